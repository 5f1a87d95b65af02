#if NETSTANDARD2_0
namespace System;

/// <summary>What strings lack on netstandard2.0.</summary>
internal static class StringExtensions
{
    /// <summary>Whether a character occurs in a text.</summary>
    public static bool Contains(this string text, char value) => text.IndexOf(value) >= 0;

    /// <summary>Whether a text starts with a character.</summary>
    public static bool StartsWith(this string text, char value) => text.Length > 0 && text[0] == value;
}
#endif
