using System;
using System.Threading;
using System.Threading.Tasks;
using Spectre.Console;

namespace Rabit.Tool;

/// <summary>
/// How far reading has come, on the error output so that the output stays clean: shown for large files, and where the
/// error output is a terminal. However the process ends, the terminal has its cursor again.
/// </summary>
internal sealed class ProgressBar : IDisposable
{
    /// <summary>Smaller files are through before a bar could be seen.</summary>
    private const long LargeFile = 16 << 20;

    private static readonly TimeSpan RefreshEvery = TimeSpan.FromMilliseconds(100);
    private static readonly TimeSpan MaxLastDrawing = TimeSpan.FromSeconds(1);

    private readonly ManualResetEventSlim _finished = new();
    private readonly Task? _drawing;
    private readonly long _length;
    private long _position;

    internal ProgressBar(IAnsiConsole? console, long length)
    {
        _length = length;
        if (console is null)
            return;
        _drawing = Task.Run(() => Draw(console));
        Console.CancelKeyPress += End;
        AppDomain.CurrentDomain.ProcessExit += End;
    }

    /// <param name="length">How much there is to read; 0 where that is not known, or no bar is wanted.</param>
    public static ProgressBar Start(long length)
    {
        if (length < LargeFile || Console.IsErrorRedirected)
            return new ProgressBar(null, length);
        IAnsiConsole console = AnsiConsole.Create(
            new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        return new ProgressBar(console.Profile.Capabilities.Interactive ? console : null, length);
    }

    public void Show(long position) => Volatile.Write(ref _position, position);

    public void Dispose()
    {
        if (_drawing is not null)
        {
            Console.CancelKeyPress -= End;
            AppDomain.CurrentDomain.ProcessExit -= End;
        }

        _finished.Set();
        _drawing?.Wait();
        _finished.Dispose();
    }

    private void End(object? sender, EventArgs e)
    {
        _finished.Set();
        _drawing!.Wait(MaxLastDrawing);
    }

    private void Draw(IAnsiConsole console) => console.Progress().AutoClear(true)
        .Columns(
            new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn(), new RemainingTimeColumn())
        .Start(context =>
        {
            ProgressTask task = context.AddTask("reading", maxValue: Math.Max(_length, 1));
            do
                task.Value = Volatile.Read(ref _position);
            while (!_finished.Wait(RefreshEvery));
        });
}
