using System;
using System.Threading;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The operator's commands: given by any thread, taken by the manager's. The newest one counts; one that could not be
/// carried out in time is dropped and logged, so that it does not come true minutes later.
/// </summary>
internal sealed class OperatorRequests(Action<string> log)
{
    // Long enough for a short loss of the link, short enough for the operator to remember it.
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(10);

    private OperatorRequest? _given; // written by any thread, taken by the manager's; replaced as a whole
    private TimeSpan _since;

    /// <summary>The command that is to be carried out; null where there is none.</summary>
    public OperatorRequest? Pending { get; private set; }

    /// <summary>Gives a command. Any thread.</summary>
    public void Give(OperatorRequest request) => Interlocked.Exchange(ref _given, request);

    /// <summary>Takes in what was given, and drops what is too old.</summary>
    /// <param name="now">The time of this tick.</param>
    /// <param name="keepsReturn">Whether a return waits without limit: we command, and the link is lost.</param>
    public void Update(TimeSpan now, bool keepsReturn)
    {
        if (Interlocked.Exchange(ref _given, null) is { } given)
        {
            (Pending, _since) = (given, now);
            log($"operator: {given.Name}, {given.Reason}");
        }

        bool isDropped = Pending is { } pending && now - _since > MaxAge
            && !(keepsReturn && pending.Command == OperatorCommand.Return);
        if (isDropped)
            Refuse($"not possible within {MissionNumbers.Seconds(MaxAge)}");
    }

    /// <summary>The command is carried out.</summary>
    public OperatorRequest? Take()
    {
        OperatorRequest? taken = Pending;
        Pending = null;
        return taken;
    }

    /// <summary>The command is not carried out; does nothing where there is none.</summary>
    public void Refuse(string why)
    {
        if (Take() is { } refused)
            log($"operator's {refused.Name} refused: {why}");
    }
}
