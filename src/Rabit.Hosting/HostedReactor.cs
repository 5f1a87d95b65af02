using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>
/// One run of a reactor, on a thread of its own. <see cref="Started"/> ends when the start-up barrier has opened,
/// <see cref="Ended"/> when all managers have. Any thread.
/// </summary>
internal sealed class HostedReactor(string name, RabitReactor reactor, IReadOnlyList<IDisposable> owned)
{
    private readonly TaskCompletionSource<bool> _started = new(TaskCreationOptions.RunContinuationsAsynchronously);
    private readonly TaskCompletionSource<ReactorResult?> _ended =
        new(TaskCreationOptions.RunContinuationsAsynchronously);

    public string Name { get; } = name;

    public RabitReactor Reactor { get; } = reactor;

    /// <summary>
    /// Whether all managers started up; ends as <see cref="RabitReactor.Start"/> does where that throws.
    /// </summary>
    public Task<bool> Started => _started.Task;

    /// <summary>Null where the run could not be started.</summary>
    public Task<ReactorResult?> Ended => _ended.Task;

    public ReactorResult? Result => Ended.Status == TaskStatus.RanToCompletion ? Ended.Result : null;

    public void Begin()
        => new Thread(Run) { Name = "reactor " + Name, IsBackground = true }.Start();

    /// <summary>The managers that have not shut down yet, by their status.</summary>
    public string[] Late()
        => Reactor.IsWired
            ? Reactor.Select(m => m.Name).Where(n => StatusOf(n).State is not ManagerState.Stopped).ToArray()
            : [];

    /// <summary>After the end.</summary>
    public void Dispose()
    {
        Reactor.Dispose();
        foreach (IDisposable manager in owned)
            manager.Dispose();
    }

    private ManagerStatus StatusOf(string manager)
    {
        MessageSubscriber<ManagerStatus> status = Reactor.Workspace.SubscribeToStatus(manager);
        status.Fetch();
        return status.Value;
    }

    private void Run()
    {
        try
        {
            Reactor.Start();
            if (Reactor.RunFor(TimeSpan.Zero))
                _started.SetResult(true);
            ReactorResult result = Reactor.Finish();

            // The first unit of work follows the barrier: a short run has started, too.
            _started.TrySetResult(result.ExitCode == 0 || result.Managers.Any(m => m.Runs > 0));
            _ended.SetResult(result);
        }
        catch (Exception e)
        {
            // The one that starts the host gets it; after the start it is an end without a result.
            _started.TrySetException(e);
            _ended.TrySetResult(null);
        }
    }
}
