using System;
using System.Threading;
using Rabit.Core.Diagnostics;
using Rabit.Core.Locks;
using Rabit.Core.Managers;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Supervision;

/// <summary>
/// Whether one manager returns from its code. Its thread enters and leaves stages; the watchdog, on its own thread,
/// looks, and posts a status in its place when it does not return.
/// </summary>
/// <remarks>
/// The race it closes: the watchdog finds the manager hanging and is about to post that, while the manager returns and
/// posts that it runs; the watchdog's status, posted last, would stay. The watchdog marks the stage and posts under one
/// lock; a manager that finds its stage marked passes through that lock before it posts. One that does not hang takes
/// no lock. Where the manager has requested a priority the lock passes it on: the watchdog may be displaced from its
/// processor while it posts.
/// <para>
/// The other one: the manager leaves the stage, and may enter the next, between the watchdog's look and its mark. Then
/// the mark fails, and nothing is posted or reported.
/// </para>
/// </remarks>
internal class HangWatch<TSync>(RabitManager manager, ManagerRun run)
    where TSync : struct, ISyncPoints
{
    /// <summary>What a manager does that is in none of its code.</summary>
    public const string Sleeping = "sleeping";

    private readonly EndpointLock _posting = new(manager.RealTimeRequest?.Priority is not null);
    private readonly StageMark<TSync> _mark = new();
    private string? _lastHang;        // written by the watchdog under _posting; read by the manager after it passed it
    private long _count;              // same
    private TimeSpan? _modelledEnd;   // in virtual time only, where there is one thread

    /// <summary>Whether a manager that returns lends its priority to the watchdog that posts.</summary>
    public bool InheritsPriority => _posting.InheritsPriority;

    public BoundedList<ManagerHang> Found { get; } = new();

    public HangPolicy Policy => manager.HangPolicy ?? run.HangPolicy;

    /// <summary>What the manager is doing. Any thread.</summary>
    public string Doing
    {
        get
        {
            string? stage = _mark.Stage switch
            {
                ManagerStage.Startup => "Startup",
                ManagerStage.UnitOfWork => "ExecuteUnitOfWork",
                ManagerStage.Shutdown => "Shutdown",
                _ => null,
            };
            return stage is null ? Sleeping : manager.Doing is { } doing ? $"{stage}: {doing}" : stage;
        }
    }

    /// <summary>
    /// Whether the modelled duration of a unit of work continues. The thread of the virtual run only.
    /// </summary>
    public bool IsInModelledWork => _modelledEnd is not null;

    public void Enter(ManagerStage stage, TimeSpan now)
    {
        manager.ForgetDoing();
        _mark.Enter(stage, now);
    }

    public void Leave(TimeSpan end)
    {
        if (_mark.Leave())
            ReportReturn(end);
    }

    /// <summary>Instead of <see cref="Leave"/>, for a unit of work whose modelled duration ends later.</summary>
    public void LeaveLater(TimeSpan begin, TimeSpan end)
    {
        if (run.WatchdogWakeUp is not { } watchdog || end - begin <= Policy.LimitOf(ManagerStage.UnitOfWork))
        {
            Leave(end);
            return;
        }

        _modelledEnd = end;
        watchdog.Wake(WakeUpCauses.Request);
    }

    /// <summary>Leaves a unit of work whose modelled duration is over.</summary>
    /// <returns>Whether there was one.</returns>
    public bool TryEndModelled(TimeSpan now)
    {
        if (_modelledEnd is not { } end || now < end)
            return false;
        _modelledEnd = null;
        if (_mark.Leave())
            ReportReturn(end);
        return true;
    }

    /// <summary>
    /// Leaves a unit of work whose modelled duration the end of the run cuts: it does not return.
    /// </summary>
    public void CutModelled(TimeSpan now)
    {
        if (!IsInModelledWork || TryEndModelled(now))
            return;
        _modelledEnd = null;
        _mark.Leave();
    }

    /// <summary>Fills in what a status holds of hangs. The manager's thread.</summary>
    public void Describe(ref ManagerStatus status)
    {
        status.Hangs = _count;
        status.LastHang = _lastHang;
        status.HangingSince = TimeSpan.Zero;
    }

    /// <summary>Checks whether the manager hangs, and reports it if it does. The watchdog's thread.</summary>
    /// <returns>When to check next, as far as is known now.</returns>
    public TimeSpan Check(TimeSpan now, StatusEndpoint status)
    {
        TimeSpan next = _modelledEnd ?? TimeSpan.MaxValue;
        if (!_mark.TryRead(out int seen, out ManagerStage stage, out TimeSpan since))
            return next;
        TimeSpan limit = Times.Later(since, Policy.LimitOf(stage));
        if (now < limit)
            return Times.Earlier(limit, next);

        var hang = new ManagerHang(manager.Name, stage, manager.Doing, since, now - since);
        using (_posting.Enter())
        {
            if (!_mark.TryMarkHanging(seen))
                return next;
            Found.Add(hang);
            _count++;
            _lastHang = hang.ToString();
            status.PostHang(since, _count, _lastHang);
        }

        Report(hang);
        return next;
    }

    private void Report(ManagerHang hang)
    {
        run.Log.Write(RabitLogKind.Hang, manager.Name, hang.ToString());
        if (Policy.StopsSystem)
            run.RequestStop(hang.ToString());
        try
        {
            Policy.Callback?.Invoke(hang);
        }
        catch (Exception e)
        {
            // User code on the watchdog's thread: the watchdog must continue.
            run.Log.Write(
                RabitLogKind.Fault, manager.Name,
                "the callback of its hang policy threw " + ExceptionText.Describe(e), e);
        }
    }

    private void ReportReturn(TimeSpan now)
    {
        using (_posting.Enter())
        {
            // The watchdog's post is over; what is posted from here on comes after it.
        }

        run.Log.Write(
            RabitLogKind.Hang, manager.Name,
            FormattableString.Invariant($"has returned, at {now.TotalSeconds:0.000} s"));
    }
}

/// <inheritdoc/>
internal sealed class HangWatch(RabitManager manager, ManagerRun run) : HangWatch<SyncPoints>(manager, run);
