using System;

namespace Rabit.Core;

/// <content>What a manager asks of the machine for its thread.</content>
public abstract partial class RabitManager
{
    // written by the engine before Startup, read by any thread
    private RealTimeReport _realTimeReport = RealTimeReport.Empty;

    /// <summary>
    /// What became of <see cref="RequestRealTime"/>; empty before <see cref="Startup"/>. It is in the log and in the
    /// <see cref="ManagerResult"/> too. Any thread.
    /// </summary>
    public RealTimeReport RealTimeReport
    {
        get => System.Threading.Volatile.Read(ref _realTimeReport);
        internal set => System.Threading.Volatile.Write(ref _realTimeReport, value);
    }

    internal RealTimeRequest? RealTimeRequest { get; private set; }

    /// <summary>
    /// Asks the machine for what a thread with deadlines needs: priority, CPUs, memory that stays, exact timers, warm
    /// code. In the constructor; it is asked for on the manager's own thread, before <see cref="Startup"/>. What is not
    /// granted is no fault: the manager runs without it, and <see cref="RealTimeReport"/> says why. In virtual time
    /// nothing is granted.
    /// </summary>
    /// <param name="request">Read now; later changes have no effect. A second request replaces the first.</param>
    /// <exception cref="InvalidOperationException">The reactor has started.</exception>
    protected void RequestRealTime(RealTimeRequest request)
    {
        Require.NotNull(request, nameof(request));
        if (_run is not null)
            throw new InvalidOperationException(
                $"Manager '{Name}' has started: real time can be requested in its constructor only.");
        RealTimeRequest = request.Copy();
        _owner.HasPriority = request.Priority is not null;
    }

    /// <summary>
    /// Runs the computing of a unit of work on made-up values, so that its code is compiled and in the caches before
    /// the first deadline. Called <see cref="RealTimeRequest.WarmUpRuns"/> times on the manager's thread, before
    /// <see cref="Startup"/>: only what the constructor made is there, and no endpoint may be used, so nothing leaves a
    /// warm-up. What it throws is in the report and is no fault.
    /// </summary>
    protected virtual void WarmUp()
    {
    }

    internal void RunWarmUp() => WarmUp();
}
