using System;

namespace Rabit.Core;

/// <summary>Argument checks that read the same on every target framework.</summary>
internal static class Require
{
    public static T NotNull<T>(T? value, string parameter)
        where T : class
        => value ?? throw new ArgumentNullException(parameter);

    public static string Name(string? value, string parameter, string what)
        => string.IsNullOrWhiteSpace(value)
            ? throw new ArgumentException($"{what} needs a name that is not empty.", parameter)
            : value!;

    public static TimeSpan Positive(TimeSpan value, string parameter, string what)
        => value > TimeSpan.Zero
            ? value
            : throw new ArgumentOutOfRangeException(parameter, value, $"{what} must be longer than zero.");
}
