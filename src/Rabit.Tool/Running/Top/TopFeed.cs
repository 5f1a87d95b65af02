using System;
using System.Threading;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Tool.Running.Top;

/// <summary>
/// Brings samples on a thread of its own, and connects again when the program has ended and one of its name has
/// started.
/// </summary>
internal sealed class TopFeed(
    RunningChoice choice, int everyMilliseconds, Action<HelloLine, SampleLine> show, Action<string> showFault)
    : IDisposable
{
    private static readonly TimeSpan RetryDelay = TimeSpan.FromSeconds(1);

    private readonly ManualResetEventSlim _ending = new();
    private readonly Lock _lock = new();
    private DiagnosticsClient? _client;   // under _lock

    /// <param name="first">The first connection, which is made before a screen is.</param>
    public void Start(DiagnosticsClient first)
    {
        _client = first;
        new Thread(() => Feed(first)) { IsBackground = true, Name = "samples" }.Start();
    }

    public void Dispose()
    {
        _ending.Set();
        lock (_lock)
            _client?.Dispose();
    }

    private void Feed(DiagnosticsClient first)
    {
        RunningChoice again = choice with { Name = first.Hello.Program };
        DiagnosticsClient? client = first;
        do
        {
            try
            {
                client ??= again.Connect();
                if (TryTake(client))
                    ShowAll(client);
            }
            catch (RunningException e) when (client is not null || e.ExitCode != ToolExitCode.NotFound)
            {
                showFault($"{e.Message.TrimEnd('.')}; waiting for {again.Name} to start again.");
            }

            catch (RunningException)
            {
                // It has not started again yet.
            }

            client?.Dispose();
            client = null;
        }
        while (!_ending.Wait(RetryDelay));
    }

    private bool TryTake(DiagnosticsClient client)
    {
        lock (_lock)
        {
            _client = client;
            return !_ending.IsSet;
        }
    }

    private void ShowAll(DiagnosticsClient client)
    {
        client.Ask(new RequestLine { Request = RequestLine.Status, EveryMilliseconds = everyMilliseconds });
        client.AllowSilence(TimeSpan.FromMilliseconds(everyMilliseconds));
        while (!_ending.IsSet)
            show(client.Hello, client.Read("status", ProtocolJson.Default.SampleLine));
    }
}
