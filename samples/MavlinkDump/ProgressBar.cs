using System;
using System.Threading;
using System.Threading.Tasks;
using Spectre.Console;

namespace MavlinkDump;

/// <summary>
/// How far reading has come, on the error output so that the output stays clean: shown for large files, on a terminal,
/// and where no lines of ours run over the same screen.
/// </summary>
internal sealed class ProgressBar : IDisposable
{
    /// <summary>Smaller files are through before a bar could be seen.</summary>
    private const long LargeFile = 16 << 20;

    private static readonly TimeSpan RefreshEvery = TimeSpan.FromMilliseconds(100);

    private readonly ManualResetEventSlim _finished = new();
    private readonly Task? _drawing;
    private readonly long _length;
    private long _position;

    internal ProgressBar(IAnsiConsole? console, long length)
    {
        _length = length;
        if (console is not null)
            _drawing = Task.Run(() => Draw(console));
    }

    public static ProgressBar Start(DumpOptions options, long length)
    {
        bool isFree = options.Format == DumpFormat.Table || Console.IsOutputRedirected;
        if (length < LargeFile || !isFree || Console.IsErrorRedirected)
            return new ProgressBar(null, length);
        IAnsiConsole console = AnsiConsole.Create(
            new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        return new ProgressBar(console.Profile.Capabilities.Interactive ? console : null, length);
    }

    public void Show(long position) => Volatile.Write(ref _position, position);

    public void Dispose()
    {
        _finished.Set();
        _drawing?.Wait();
        _finished.Dispose();
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
