using System.IO;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace UavConsole.Tests.Screen;

/// <summary>What a screen shows on a terminal without colours and control characters.</summary>
internal static class PlainConsole
{
    public static string Draw(IRenderable screen, int width, int height)
    {
        var output = new StringWriter();
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.No,
            ColorSystem = ColorSystemSupport.NoColors,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(output),
        });
        (console.Profile.Width, console.Profile.Height) = (width, height);
        console.Write(screen);
        return output.ToString();
    }
}
