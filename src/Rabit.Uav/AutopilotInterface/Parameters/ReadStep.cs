using System;
using Rabit.Mavlink;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>Reads one parameter. That it is not answered is no fault: it stays unknown.</summary>
internal sealed class ReadStep(MavlinkParameterClient client, KnownParameters known, string name) : SetupStep
{
    private bool _isNeedless;

    public override bool TryStart(TimeSpan now)
    {
        // Another name of the same parameter may have been answered meanwhile.
        _isNeedless = known.IsAnswered(name) && !known.Find(name).IsKnown;
        return _isNeedless || client.TryStartRead(name, now);
    }

    public override bool TryFinish(TimeSpan now, out string? fault)
    {
        fault = null;
        return _isNeedless || client.TryTakeOutcome(out _);
    }
}
