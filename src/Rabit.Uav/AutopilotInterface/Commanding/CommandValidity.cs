using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Whether the newest command of Mission Control still stands: each carries a validity and is renewed. No I/O, one
/// thread.
/// </summary>
internal sealed class CommandValidity
{
    // Where an autopilot reports no landed state.
    private const double OnGroundHeightMetres = 2;

    private static readonly TimeSpan RetryPeriod = TimeSpan.FromSeconds(1);

    private long _id;
    private VehicleCommandKind _kind;
    private TimeSpan _validity;
    private TimeSpan _renewedAt;
    private TimeSpan? _returnDue;

    /// <summary>Whether the vehicle is in the air, as far as it reports.</summary>
    public static bool IsFlying(in VehicleState vehicle) => vehicle.IsArmed && vehicle.LandedState switch
    {
        MavLandedState.InAir or MavLandedState.Takeoff or MavLandedState.Landing => true,
        MavLandedState.OnGround => false,
        _ => vehicle.HeightAboveHomeMetres > OnGroundHeightMetres,
    };

    /// <summary>Takes a renewal.</summary>
    /// <returns>Whether it is one.</returns>
    public bool TryRenew(in VehicleCommand command, TimeSpan now)
    {
        if (command.Id != _id || command.Kind != _kind || _id == 0)
            return false;
        _renewedAt = now;
        return true;
    }

    /// <summary>Takes a new command. One to the camera moves no vehicle, and needs no renewal.</summary>
    public void Take(in VehicleCommand command, TimeSpan now)
    {
        if (command.Kind == VehicleCommandKind.PointCamera)
            return;
        (_id, _kind, _validity, _renewedAt) = (command.Id, command.Kind, command.Validity, now);
        _returnDue = null;
    }

    /// <summary>The command was taken away: nothing stands any more.</summary>
    public void Stop() => (_id, _validity, _returnDue) = (0, TimeSpan.Zero, null);

    /// <summary>Whether the validity has passed, once.</summary>
    public bool TryExpire(TimeSpan now)
    {
        bool isReturning = _kind is VehicleCommandKind.Return or VehicleCommandKind.Land;
        if (isReturning || _validity <= TimeSpan.Zero || now - _renewedAt <= _validity)
            return false;
        Stop();
        _returnDue = now;
        return true;
    }

    /// <summary>Whether the return is to be commanded now: until it is done, once a second.</summary>
    public bool OwesReturn(TimeSpan now)
    {
        if (_returnDue is not { } due || now < due)
            return false;
        _returnDue = now + RetryPeriod;
        return true;
    }

    /// <summary>The return was accepted.</summary>
    public void EndReturn() => _returnDue = null;
}
