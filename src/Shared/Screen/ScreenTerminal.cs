using System;
using System.IO;
using Spectre.Console;

namespace Rabit.Terminal;

/// <summary>The terminal of the screen.</summary>
/// <param name="output">What is written there goes to it.</param>
/// <param name="size">Columns and lines as they are now: they change when a window is resized.</param>
/// <param name="colours">What colours it has.</param>
/// <param name="isUnicode">Whether it knows more than ASCII.</param>
internal sealed class ScreenTerminal(
    TextWriter output, Func<(int Columns, int Rows)> size, ColorSystem colours, bool isUnicode)
{
    public TextWriter Output { get; } = output;

    public (int Columns, int Rows) Size => size();

    public ColorSystem Colours { get; } = colours;

    public bool IsUnicode { get; } = isUnicode;

    /// <summary>Standard output; without colours where NO_COLOR is set.</summary>
    public static ScreenTerminal OfConsole()
    {
        Profile profile = AnsiConsole.Profile;
        return new ScreenTerminal(
            Console.Out, () => (profile.Width, profile.Height), profile.Capabilities.ColorSystem,
            profile.Capabilities.Unicode);
    }
}
