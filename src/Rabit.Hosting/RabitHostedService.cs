using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>
/// Starts the reactors with the host, one after the other, each up to its start-up barrier; stops them with the host,
/// in order within its time; and stops the host when one of them ends.
/// </summary>
internal sealed class RabitHostedService(
    ReactorFactory factory, HostedReactors reactors, ExitCode exitCode, IHostApplicationLifetime lifetime,
    ILogger<RabitHostedService> logger)
    : IHostedService, IDisposable
{
    private readonly List<HostedReactor> _running = [];   // by the thread that starts, stops and disposes the host
    private volatile bool _isStopping;

    public async Task StartAsync(CancellationToken cancellationToken)
    {
        List<HostedReactor> made = factory.Make();
        CheckWiring(made);
        made.ForEach(reactors.Add);
        try
        {
            foreach (HostedReactor reactor in made)
            {
                _running.Add(reactor);
                await StartAsync(reactor, cancellationToken).ConfigureAwait(false);
            }
        }
        catch (Exception)
        {
            await StopAsync(CancellationToken.None).ConfigureAwait(false);
            throw;
        }
    }

    public async Task StopAsync(CancellationToken cancellationToken)
    {
        _isStopping = true;
        foreach (HostedReactor reactor in _running)
            reactor.Reactor.Stop("the host stops");
        Task all = Task.WhenAll(_running.Select(r => r.Ended));
        var outOfTime = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        using (cancellationToken.Register(() => outOfTime.TrySetResult(true)))
            await Task.WhenAny(all, outOfTime.Task).ConfigureAwait(false);
        foreach (HostedReactor reactor in _running)
            Report(reactor);
    }

    public void Dispose()
    {
        foreach (HostedReactor reactor in _running.Where(r => r.Ended.IsCompleted))
            reactor.Dispose();
    }

    // Of all reactors, before the first of them starts.
    private static void CheckWiring(List<HostedReactor> made)
    {
        string[] faults = made.SelectMany(
            r => r.Reactor.FindWiringFaults().Select(f => made.Count == 1 ? f : $"{r.Name}: {f}")).ToArray();
        if (faults.Length == 0)
            return;
        made.ForEach(r => r.Dispose());
        throw new RabitWiringException(faults);
    }

    private async Task StartAsync(HostedReactor reactor, CancellationToken cancellationToken)
    {
        // A manager that hangs in its start-up ends the wait of a host that has a limit for it.
        using CancellationTokenRegistration stop = cancellationToken.Register(
            () => reactor.Reactor.Stop("the start of the host was cancelled"));
        reactor.Begin();
        if (await reactor.Started.ConfigureAwait(false))
        {
            _ = WatchAsync(reactor);
            return;
        }

        ReactorResult? result = await reactor.Ended.ConfigureAwait(false);
        exitCode.Report(Math.Max(1, result?.ExitCode ?? 1));
        cancellationToken.ThrowIfCancellationRequested();
        throw new RabitHostingException([$"{reactor.Name}: {result}"], result?.Failure);
    }

    private async Task WatchAsync(HostedReactor reactor)
    {
        ReactorResult? result = await reactor.Ended.ConfigureAwait(false);
        exitCode.Report(result?.ExitCode ?? 1);
        if (_isStopping)
            return;
        LogLevel level = result?.ExitCode == 0 ? LogLevel.Information : LogLevel.Error;
        HostLog.ReactorEnded(logger, level, reactor.Name, result);

        // A host that is stopped while it starts has failed to start.
        lifetime.ApplicationStarted.Register(lifetime.StopApplication);
    }

    private void Report(HostedReactor reactor)
    {
        if (!reactor.Ended.IsCompleted)
        {
            exitCode.Report(1);
            string late = string.Join(", ", reactor.Late());
            HostLog.NotStopped(logger, reactor.Name, "the time of the host", late);
            return;
        }

        exitCode.Report(reactor.Result?.ExitCode ?? 1);
        foreach (string manager in reactor.Result?.Managers.SelectMany(m => m.NotStopped) ?? [])
            HostLog.NotStopped(logger, reactor.Name, "its time", manager);
    }
}
