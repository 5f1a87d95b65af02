using System;

namespace Rabit.Core.Diagnostics;

/// <summary>
/// Reads texts of exceptions, the only place of the library that does. An exception is foreign code: the members that
/// give its texts may throw, return null, or return a text that fills the memory or has several lines. What is read
/// here is never null, is one line and bounded, and reading it never throws.
/// </summary>
internal static class ExceptionText
{
    /// <summary>So many characters are kept of a text: more than a long message has, less than a log minds.</summary>
    public const int MaxLength = 2000;

    private const string Cut = " ... (cut)";

    /// <summary>The name of the type and the message.</summary>
    public static string Describe(Exception exception) => $"{exception.GetType().Name}: {MessageOf(exception)}";

    /// <summary>The message.</summary>
    public static string MessageOf(Exception exception)
    {
        try
        {
            return exception.Message is { } message ? Shorten(message) : "(its message is null)";
        }
        catch (Exception e)
        {
            // Foreign code; of what it throws only the type is read, which is not the exception's own code.
            return $"(its message cannot be read: {e.GetType().Name})";
        }
    }

    /// <summary>Where it was thrown: the first line of the stack trace.</summary>
    /// <returns>Empty where there is none, or it cannot be read.</returns>
    public static string PlaceOf(Exception exception)
    {
        try
        {
            string trace = exception.StackTrace ?? string.Empty;
            int end = trace.IndexOf('\n');
            return Shorten((end < 0 ? trace : trace.Remove(end)).Trim());
        }
        catch (Exception)
        {
            // See MessageOf. The message says what happened; the place is a help.
            return string.Empty;
        }
    }

    private static string Shorten(string text)
    {
        if (text.Length <= MaxLength)
            return OneLine.Of(text);
        int end = MaxLength - Cut.Length;
        return OneLine.Of(text.Remove(char.IsHighSurrogate(text[end - 1]) ? end - 1 : end)) + Cut;
    }
}
