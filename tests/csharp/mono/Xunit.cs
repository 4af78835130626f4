// SPDX-License-Identifier: MIT
// The part of xunit that these tests use, for Mono without packages. On .NET they run with the real xunit.
using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Reflection;

namespace Xunit
{
    [AttributeUsage(AttributeTargets.Method)]
    public sealed class FactAttribute : Attribute
    {
    }

    [AttributeUsage(AttributeTargets.Assembly)]
    public sealed class CollectionBehaviorAttribute : Attribute
    {
        public bool DisableTestParallelization { get; set; }
    }

    public static class Assert
    {
        public static void True(bool condition, string message = "expected true")
        {
            if (!condition)
            {
                throw new InvalidOperationException(message);
            }
        }

        public static void False(bool condition, string message = "expected false")
        {
            True(!condition, message);
        }

        public static void Equal<T>(T expected, T actual)
        {
            True(Alike(expected, actual), "expected " + expected + ", not " + actual);
        }

        public static void Equal(double expected, double actual, double tolerance)
        {
            True(Math.Abs(expected - actual) <= tolerance, "expected " + expected + ", not " + actual);
        }

        public static void NotEqual<T>(T expected, T actual)
        {
            False(Alike(expected, actual), "expected anything but " + expected);
        }

        public static void InRange<T>(T actual, T low, T high)
            where T : IComparable
        {
            True(actual.CompareTo(low) >= 0 && actual.CompareTo(high) <= 0, actual + " is not in the range");
        }

        public static void All<T>(IEnumerable<T> items, Action<T> check)
        {
            foreach (T item in items)
            {
                check(item);
            }
        }

        public static void NotNull(object value)
        {
            True(value != null, "expected something, not null");
        }

        public static void Null(object value)
        {
            True(value == null, "expected null, not " + value);
        }

        public static void Same(object expected, object actual)
        {
            True(ReferenceEquals(expected, actual), "expected the same object");
        }

        public static void Empty(IEnumerable values)
        {
            foreach (object value in values)
            {
                True(false, "expected nothing, not " + value);
            }
        }

        public static T Single<T>(IEnumerable<T> values)
        {
            var list = new List<T>(values);
            Equal(1, list.Count);
            return list[0];
        }

        public static void Contains(string part, string text)
        {
            True(text != null && text.Contains(part), "expected '" + part + "' in '" + text + "'");
        }

        public static T IsType<T>(object value)
        {
            True(value != null && value.GetType() == typeof(T), "expected a " + typeof(T).Name + ", not " + value);
            return (T)value;
        }

        public static T Throws<T>(Func<object> function)
            where T : Exception
        {
            return Throws<T>(() => { function(); });
        }

        public static T Throws<T>(Action action)
            where T : Exception
        {
            try
            {
                action();
            }
            catch (Exception exception)
            {
                if (exception.GetType() == typeof(T))
                {
                    return (T)exception;
                }
                throw new InvalidOperationException("expected a " + typeof(T).Name + ", not " + exception, exception);
            }
            throw new InvalidOperationException("expected a " + typeof(T).Name + ", but nothing was thrown");
        }

        private static bool Alike(object expected, object actual)
        {
            var left = expected as Array;
            var right = actual as Array;
            if (left == null || right == null)
            {
                return Equals(expected, actual);
            }
            if (left.Length != right.Length)
            {
                return false;
            }
            for (int i = 0; i < left.Length; ++i)
            {
                if (!Equals(left.GetValue(i), right.GetValue(i)))
                {
                    return false;
                }
            }
            return true;
        }
    }

    public static class Runner
    {
        public static int Main(string[] arguments)
        {
            int passed = 0, failed = 0;
            foreach (Type type in typeof(Runner).Assembly.GetTypes())
            {
                foreach (MethodInfo method in type.GetMethods(BindingFlags.Public | BindingFlags.Instance))
                {
                    string name = type.Name + "." + method.Name;
                    bool wanted = arguments.Length == 0 || name.Contains(arguments[0]);
                    if (method.GetCustomAttributes(typeof(FactAttribute), false).Length == 0 || !wanted)
                    {
                        continue;
                    }
                    Stopwatch watch = Stopwatch.StartNew();
                    Exception problem = Run(type, method);
                    Console.WriteLine("{0,6} ms  {1}  {2}", watch.ElapsedMilliseconds, problem == null ? "ok" : "FAILED", name);
                    if (problem == null)
                    {
                        ++passed;
                        continue;
                    }
                    ++failed;
                    Console.WriteLine(problem);
                }
            }
            Console.WriteLine("{0} passed, {1} failed", passed, failed);
            return failed == 0 && passed > 0 ? 0 : 1;
        }

        private static Exception Run(Type type, MethodInfo method)
        {
            object instance = null;
            try
            {
                instance = Activator.CreateInstance(type);
                method.Invoke(instance, null);
                return null;
            }
            catch (TargetInvocationException exception)
            {
                return exception.InnerException;
            }
            finally
            {
                (instance as IDisposable)?.Dispose();
            }
        }
    }
}
