using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>What it reports.</summary>
internal sealed partial class StandInVehicle
{
    private void Post()
    {
        _nextPost = Now + TimeSpan.FromSeconds(0.2);
        if (!HealthHangs)
        {
            _health.Value = Health;
            _health.Post();
        }

        if (Hangs)
            return;
        _authority.Value = Authority;
        _authority.Post();
        _imaging.Value = new ImagingStatus { HasCamera = HasCamera };
        _imaging.Post();
        if (IsConnected)
            _lastHeartbeat = Now;
        ref VehicleState state = ref _vehicle.Value;
        state.IsConnected = Now - _lastHeartbeat < TimeSpan.FromSeconds(3);
        if (IsConnected)
            Describe(ref state);
        _vehicle.Post();
    }

    private void Describe(ref VehicleState state)
    {
        state.SystemId = 1;
        state.LastHeartbeatTime = Now;
        state.IsArmed = IsArmed;
        state.SystemStatus = SystemStatus;
        bool isDown = Height < 0.05;
        state.LandedState = !ReportsLandedState ? MavLandedState.Undefined
            : isDown ? MavLandedState.OnGround
            : _task.Kind == VehicleCommandKind.Land ? MavLandedState.Landing : MavLandedState.InAir;
        if (ReportsLandedState)
            state.LandedStateTime = Now;
        state.EstimatorTime = Now;
        state.EstimatorFlags = HasValidPosition ? EstimatorStatusFlags.PosHorizAbs : EstimatorStatusFlags.ConstPosMode;
        if (HasPosition)
            DescribePosition(ref state);
        state.GpsTime = Now;
        state.GpsFix = Fix;
        state.GnssAltitudeAmslMetres = state.Position.AltitudeAmslMetres + GnssAboveMetres;
        state.BatteryTime = Now;
        state.BatteryRemaining = Battery;
        More?.Invoke(ref state);
    }

    // What is not reported any more stays as it was.
    private void DescribePosition(ref VehicleState state)
    {
        state.PositionTime = Now;
        state.Position = _frame.ToGeodetic(new NedPosition(North, East, -Height));
        state.HeightAboveHomeMetres = Height;
        state.VelocityNed = new NedVector(_vn, _ve, _vd);
    }
}
