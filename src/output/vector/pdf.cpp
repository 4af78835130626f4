// SPDX-License-Identifier: MIT
#include "output/vector/shapes.h"
#include "output/vector/text_out.h"
#include "output/vector/writers.h"

#include <algorithm>
#include <array>
#include <bitset>

namespace hrbfnpr::output {
namespace {

using drawing::Cap;
using glm::dvec2;

constexpr double points_of_mm = 72.0 / 25.4;
// The objects' numbers, which those of groups follow.
enum Object : std::int64_t { content = 1, content_length, catalog, pages, page, information, first_of_groups };

// The character that begins at text[at], which is UTF-8; `at` goes on to the next.
std::uint32_t next_character(std::string_view text, std::size_t& at) noexcept {
    const auto lead = static_cast<std::uint8_t>(text[at++]);
    const std::uint32_t more = lead < 0xC0 ? 0U : lead < 0xE0 ? 1U : lead < 0xF0 ? 2U : 3U;
    std::uint32_t code = more == 0 ? lead : lead & (0x3FU >> more);
    for (std::uint32_t i = 0; i < more && at < text.size(); ++i)
        code = code << 6U | (static_cast<std::uint8_t>(text[at++]) & 0x3FU);
    return code;
}

class PdfWriter final : public PageSink, private ShapeSink {
public:
    PdfWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, const ShapeSettings& settings,
              PageCounts& counts)
        : out_(writer), page_(page), settings_(settings), counts_(counts), shapes_(memory, settings), groups_(memory),
          offsets_(memory) {
        out_ << "%PDF-1.5\n%\xE2\xE3\xCF\xD3\n";
        begin_object();
        out_ << "<< /Length " << std::int64_t{content_length} << " 0 R >>\nstream\n";
        content_ = out_.bytes();
        // Units are millimetres from the top-left corner, with y down.
        out_.precise(points_of_mm) << " 0 0 ";
        out_.precise(-points_of_mm) << " 0 ";
        out_.precise(points_of_mm * page.height) << " cm\n1 j\n";
    }

    void begin_view(const PageView& view) override {
        paper_ = view.paper;
        const auto frame = [&] {
            out_ << view.frame.left << ' ' << view.frame.top << ' ' << view.frame.right - view.frame.left << ' '
                 << view.frame.bottom - view.frame.top << " re\n";
        };
        out_ << "q\n";
        frame();
        out_ << "W n\n";
        if (!view.with_paper || !(paper_.w > 0.0F)) return;
        begin_content("paper");
        set_ink(paper_);
        set_opacity(static_cast<double>(paper_.w));
        frame();
        out_ << "f\nEMC\n";
    }
    void begin_group(const PageGroup& group) override {
        group_ = group;
        ++counts_.groups;
        begin_content(group.name);
        set_ink(group.ink);
    }
    void path(const PagePath& path) override {
        ++counts_.paths;
        shapes_.shape(path, group_, *this);
    }
    // A disc is a line of no length with round ends.
    void dot(const PageDot& dot) override {
        ++counts_.dots;
        set_ink(dot.is_paper ? paper_ : group_.ink);
        if (settings_.dots_of(group_.pen_width) != DotShapes::circles) {
            shapes_.shape(dot, group_, *this);
            return;
        }
        begin_line(2.0 * dot.radius, Cap::round, dot.opacity);
        move_to({dot.x, dot.y});
        line_to({dot.x, dot.y});
        end_shape();
    }
    // All viewers have Helvetica and its Latin letters; others become '?'.
    void text(const PageText& text) override {
        set_ink(group_.ink);
        set_opacity(static_cast<double>(group_.ink.w));
        out_ << "BT /F1 " << text.height / capitals_of_size << " Tf 1 0 0 -1 " << text.x << ' ' << text.y << " Tm (";
        const std::string_view all = text.text;
        for (std::size_t at = 0; at < all.size();) {
            const std::uint32_t code = next_character(all, at);
            const bool known = (code >= 0x20 && code < 0x7F) || (code >= 0xA0 && code < 0x100);
            const char c = known ? static_cast<char>(static_cast<std::uint8_t>(code)) : '?';
            if (c == '(' || c == ')' || c == '\\') out_ << '\\';
            out_ << c;
        }
        out_ << ") Tj ET\n";
    }
    void end_group() override { out_ << "EMC\n"; }
    // The graphics state of before the view is restored.
    void end_view() override {
        out_ << "Q\n";
        ink_ = glm::vec4(-1.0F);
        width_ = -1.0;
        cap_ = alpha_ = -1;
    }
    void finish() override {
        const std::int64_t length = out_.bytes() - content_;
        out_ << "\nendstream";
        end_object();
        begin_object();
        out_ << length;
        end_object();
        write_catalog(first_of_groups);
        write_page(first_of_groups);
        write_information();
        for (const Name& name : groups_) {
            begin_object();
            out_ << "<< /Type /OCG /Name ";
            string(name.text);
            out_ << " >>";
            end_object();
        }
        write_references();
        out_.flush();
        counts_.bytes = out_.bytes();
    }

private:
    void begin_fill(double opacity) override {
        set_opacity(opacity * static_cast<double>(group_.ink.w));
        fills_ = true;
    }
    void begin_line(double width, Cap cap, double opacity) override {
        set_opacity(opacity * static_cast<double>(group_.ink.w));
        set_line(width, cap);
        fills_ = false;
    }
    void move_to(const dvec2& p) override {
        place(p);
        out_ << " m\n";
    }
    void line_to(const dvec2& p) override {
        place(p);
        out_ << " l\n";
        ++counts_.segments;
    }
    void curve_to(const geometry::Cubic& cubic) override {
        place(cubic.control_1);
        out_ << ' ';
        place(cubic.control_2);
        out_ << ' ';
        place(cubic.end);
        out_ << " c\n";
        ++counts_.segments;
    }
    void close() override { out_ << "h\n"; }
    void end_shape() override { out_ << (fills_ ? "f\n" : "S\n"); }

    std::int64_t begin_object() {
        offsets_.push_back(out_.bytes());
        out_ << offsets_.size() << " 0 obj\n";
        return offsets_.size();
    }
    void end_object() { out_ << "\nendobj\n"; }
    // Titles and names are in UTF-16.
    void string(std::string_view text) {
        constexpr std::string_view digits = "0123456789ABCDEF";
        const auto unit = [&](std::uint32_t code) {
            for (int shift = 12; shift >= 0; shift -= 4) out_ << digits[code >> static_cast<unsigned>(shift) & 15U];
        };
        out_ << "<FEFF";
        for (std::size_t at = 0; at < text.size();) {
            const std::uint32_t code = next_character(text, at);
            if (code < 0x10000) {
                unit(code);
            } else {
                unit(0xD800 + ((code - 0x10000) >> 10U));
                unit(0xDC00 + ((code - 0x10000) & 0x3FFU));
            }
        }
        out_ << '>';
    }
    void begin_content(std::string_view name) {
        Name kept{};
        name.copy(kept.text, sizeof kept.text - 1);
        groups_.push_back(kept);
        out_ << "/OC /G" << groups_.size() << " BDC\n";
    }
    void set_ink(const glm::vec4& ink) {
        if (glm::vec3(ink) == glm::vec3(ink_)) return;
        ink_ = ink;
        for (const char* operation : {" rg\n", " RG\n"}) {
            out_ << static_cast<double>(ink.x) << ' ' << static_cast<double>(ink.y) << ' '
                 << static_cast<double>(ink.z);
            out_ << operation;
        }
    }
    void set_opacity(double opacity) {
        const auto alpha = static_cast<int>(std::clamp(opacity, 0.0, 1.0) * 255.0 + 0.5);
        if (alpha == alpha_) return;
        alpha_ = alpha;
        alphas_.set(static_cast<std::size_t>(alpha));
        out_ << "/A" << std::int64_t{alpha} << " gs\n";
    }
    void set_line(double width, Cap cap) {
        if (width != width_) out_ << width << " w\n";
        width_ = width;
        const int number = cap == Cap::round ? 1 : 0;
        if (number != cap_) out_ << std::int64_t{number} << " J\n";
        cap_ = number;
    }
    void place(const dvec2& p) { out_ << p.x << ' ' << p.y; }
    void write_catalog(std::int64_t first_group) {
        begin_object();
        out_ << "<< /Type /Catalog /Pages " << std::int64_t{pages} << " 0 R /PageMode /UseOC /OCProperties << /OCGs [";
        const auto list = [&] {
            for (std::int64_t i = 0; i < groups_.size(); ++i) out_ << ' ' << first_group + i << " 0 R";
        };
        list();
        out_ << " ] /D << /Order [";
        list();
        out_ << " ] /ON [";
        list();
        out_ << " ] >> >> >>";
        end_object();
    }
    void write_page(std::int64_t first_group) {
        begin_object();
        out_ << "<< /Type /Pages /Count 1 /Kids [ " << std::int64_t{page} << " 0 R ] >>";
        end_object();
        begin_object();
        out_ << "<< /Type /Page /Parent " << std::int64_t{pages} << " 0 R /MediaBox [ 0 0 "
             << points_of_mm * page_.width << ' ' << points_of_mm * page_.height << " ] /Contents "
             << std::int64_t{content}
             << " 0 R\n/Resources << /Font << /F1 << /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding "
                "/WinAnsiEncoding >> >>\n/ExtGState <<";
        for (std::size_t i = 0; i < alphas_.size(); ++i)
            if (alphas_.test(i))
                out_ << " /A" << static_cast<std::int64_t>(i) << " << /ca " << static_cast<double>(i) / 255.0 << " /CA "
                     << static_cast<double>(i) / 255.0 << " >>";
        out_ << " >>\n/Properties <<";
        for (std::int64_t i = 0; i < groups_.size(); ++i) out_ << " /G" << i + 1 << ' ' << first_group + i << " 0 R";
        out_ << " >> >> >>";
        end_object();
    }
    void write_information() {
        begin_object();
        out_ << "<< /Producer (hrbfnpr " << page_.program << ')';
        const auto entry = [&](const char* name, const char* text) {
            if (text == nullptr || *text == '\0') return;
            out_ << ' ' << name << ' ';
            string(text);
        };
        entry("/Title", page_.title);
        entry("/Subject", page_.description);
        entry("/Keywords", page_.metadata);
        out_ << " >>";
        end_object();
    }
    void write_references() {
        const std::int64_t start = out_.bytes();
        out_ << "xref\n0 " << offsets_.size() + 1 << "\n0000000000 65535 f \n";
        for (const std::int64_t offset : offsets_) {
            std::array<char, 11> digits{};
            std::int64_t rest = offset;
            for (std::size_t i = 10; i-- > 0; rest /= 10) digits[i] = static_cast<char>('0' + rest % 10);
            out_ << digits.data() << " 00000 n \n";
        }
        out_ << "trailer\n<< /Size " << offsets_.size() + 1 << " /Root " << std::int64_t{catalog} << " 0 R /Info "
             << std::int64_t{information} << " 0 R >>\nstartxref\n"
             << start << "\n%%EOF\n";
    }

    struct Name {
        char text[PageGroup::most];
    };

    TextOut out_;
    PageInfo page_;
    ShapeSettings settings_;
    PageCounts& counts_;
    Shapes shapes_;
    PageGroup group_;
    glm::vec4 ink_{-1.0F}; // as set
    glm::vec4 paper_{0.0F};
    double width_ = -1.0;
    int cap_ = -1, alpha_ = -1;
    bool fills_ = false;
    std::bitset<256> alphas_; // the ones that are used
    base::Array<Name> groups_;
    base::Array<std::int64_t> offsets_; // where each object begins in the file, bytes; object 1 is the first
    std::int64_t content_ = 0;          // where the stream begins
};

} // namespace

std::unique_ptr<PageSink> pdf_writer(base::Memory& memory, io::Writer& writer, const PageInfo& page,
                                     const PageSettings& settings, PageCounts& counts) {
    return std::make_unique<PdfWriter>(memory, writer, page, settings.shapes, counts);
}

} // namespace hrbfnpr::output
