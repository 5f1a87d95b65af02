using System;

namespace Rabit.Core;

/// <summary>Argument checks that read the same on every target framework.</summary>
internal static class Require
{
    public static T NotNull<T>(T? value, string parameter)
        where T : class
        => value ?? throw new ArgumentNullException(parameter);

    // Names stand in logs of one line for each entry.
    public static string Name(string? value, string parameter, string what)
    {
        if (string.IsNullOrWhiteSpace(value))
            throw new ArgumentException($"{what} needs a name that is not empty.", parameter);
        foreach (char c in value!)
        {
            if (char.IsControl(c) || c is '\u2028' or '\u2029')
                throw new ArgumentException(
                    FormattableString.Invariant($"{what} needs a name on one line: it has the character U+{(int)c:X4}."),
                    parameter);
        }

        return value;
    }

    public static TimeSpan Positive(TimeSpan value, string parameter, string what)
        => value > TimeSpan.Zero
            ? value
            : throw new ArgumentOutOfRangeException(parameter, value, $"{what} must be longer than zero.");
}
