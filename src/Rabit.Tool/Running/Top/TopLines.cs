using System;
using System.Globalization;
using System.IO;
using System.Linq;
using Rabit.Diagnostics.Protocol;
using Spectre.Console;

namespace Rabit.Tool.Running.Top;

/// <summary>Plain text where the output is no terminal: all rows of each sample.</summary>
internal sealed class TopLines(TopSettings settings)
{
    // No line is broken or cut off.
    private const int Width = 400;

    private readonly TopView _view = new(settings);

    /// <param name="client">The program.</param>
    /// <param name="everyMilliseconds">From one sample to the next.</param>
    /// <param name="count">How many; null until the program ends.</param>
    /// <returns>The exit code.</returns>
    public int Run(DiagnosticsClient client, int everyMilliseconds, int? count)
    {
        client.Ask(new RequestLine { Request = RequestLine.Status, EveryMilliseconds = everyMilliseconds });
        client.AllowSilence(TimeSpan.FromMilliseconds(everyMilliseconds));
        int written = 0;
        try
        {
            // The first one has no rates.
            _view.Show(client.Hello, client.Read("status", ProtocolJson.Default.SampleLine));
            for (; count is null || written < count; written++)
            {
                _view.Show(client.Hello, client.Read("status", ProtocolJson.Default.SampleLine));
                Console.WriteLine(Text());
            }
        }
        catch (RunningException e) when (count is null && written > 0)
        {
            Console.Error.WriteLine("rabit top: " + e.Message);
        }

        return ToolExitCode.Done;
    }

    private string Text()
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture);
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.No,
            ColorSystem = ColorSystemSupport.NoColors,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(text),
        });
        console.Profile.Width = Width;
        console.Write(_view.DrawLines(Width));
        return string.Join('\n', text.ToString().Split('\n').Select(line => line.TrimEnd())).TrimEnd('\n') + "\n";
    }
}
