using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("HrbfNpr.Tests")]
