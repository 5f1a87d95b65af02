using System.Collections.Generic;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Communications;

/// <summary>Which class a frame belongs to, by its message; and which value of state it is.</summary>
internal static class SendClasses
{
    // Where fields start on the wire (sorted by size): name and id of an instance, severity, command.
    private const int NameOffset = 8;
    private const int NameLength = 10;
    private const int BatteryIdOffset = 32;
    private const int SeverityOffset = 0;
    private const int CommandOffset = 28;
    private const int TunnelOffset = 5;

    private static readonly HashSet<int> Commands =
    [
        CommandLong.MavlinkId, CommandInt.MavlinkId, CommandAck.MavlinkId, CommandCancel.MavlinkId, SetMode.MavlinkId,
        SetAttitudeTarget.MavlinkId, SetPositionTargetLocalNed.MavlinkId, SetPositionTargetGlobalInt.MavlinkId,
        ManualControl.MavlinkId, RcChannelsOverride.MavlinkId, Timesync.MavlinkId, Ping.MavlinkId,
    ];

    private static readonly HashSet<int> Coordination =
    [
        Statustext.MavlinkId, Event.MavlinkId, CurrentEventSequence.MavlinkId,
        RequestEvent.MavlinkId, ResponseEventError.MavlinkId, MissionItemReached.MavlinkId,
        CameraImageCaptured.MavlinkId, Collision.MavlinkId,
    ];

    // Periodic telemetry: who missed a value is served by the next one.
    private static readonly HashSet<int> State =
    [
        SysStatus.MavlinkId, SystemTime.MavlinkId, GpsRawInt.MavlinkId, GpsStatus.MavlinkId, Gps2Raw.MavlinkId,
        Attitude.MavlinkId, AttitudeQuaternion.MavlinkId, AttitudeTarget.MavlinkId, LocalPositionNed.MavlinkId,
        GlobalPositionInt.MavlinkId, PositionTargetLocalNed.MavlinkId, PositionTargetGlobalInt.MavlinkId,
        RcChannels.MavlinkId, RcChannelsRaw.MavlinkId, ServoOutputRaw.MavlinkId, MissionCurrent.MavlinkId,
        NavControllerOutput.MavlinkId, VfrHud.MavlinkId, RawImu.MavlinkId, ScaledImu.MavlinkId, ScaledImu2.MavlinkId,
        ScaledImu3.MavlinkId, ScaledPressure.MavlinkId, ScaledPressure2.MavlinkId, HighresImu.MavlinkId,
        PowerStatus.MavlinkId, BatteryStatus.MavlinkId, Altitude.MavlinkId, EstimatorStatus.MavlinkId,
        EkfStatusReport.MavlinkId, WindCov.MavlinkId, Wind.MavlinkId, Vibration.MavlinkId, HomePosition.MavlinkId,
        ExtendedSysState.MavlinkId, NamedValueFloat.MavlinkId, NamedValueInt.MavlinkId, DistanceSensor.MavlinkId,
        TerrainReport.MavlinkId, Meminfo.MavlinkId, Ahrs.MavlinkId, Ahrs2.MavlinkId, Hwstatus.MavlinkId,
        OnboardComputerStatus.MavlinkId, CameraTrackingGeoStatus.MavlinkId, GimbalDeviceAttitudeStatus.MavlinkId,
        RadioStatus.MavlinkId, EscStatus.MavlinkId, FollowTarget.MavlinkId, UtmGlobalPosition.MavlinkId,
        LandingTarget.MavlinkId,
    ];

    /// <summary>The class of a frame.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="keepsOrder">
    /// Whether it was signed by another: what overtakes such frames makes the receiver refuse them, since their stamps
    /// must rise.
    /// </param>
    public static SendClass Of(in MavlinkFrame frame, bool keepsOrder = false)
    {
        if (keepsOrder)
            return SendClass.Coordination;
        int id = frame.MessageId;
        if (id == Heartbeat.MavlinkId || IsEmergency(frame))
            return SendClass.Urgent;
        if (id == Tunnel.MavlinkId)
            return OfTunnel(frame);
        return Commands.Contains(id) ? SendClass.Commands
            : Coordination.Contains(id) ? SendClass.Coordination
            : State.Contains(id) ? SendClass.State
            : SendClass.Bulk;
    }

    /// <summary>
    /// The same for all values of one piece of state: sender, message, and instance where it has some.
    /// </summary>
    public static ulong KeyOf(in MavlinkFrame frame)
    {
        ulong key = ((ulong)frame.SystemId << 56) | ((ulong)frame.ComponentId << 48) | (uint)frame.MessageId;
        if (frame.MessageId == BatteryStatus.MavlinkId)
            return key | ((ulong)frame.PayloadByte(BatteryIdOffset) << 24);
        if (frame.MessageId is not (NamedValueFloat.MavlinkId or NamedValueInt.MavlinkId))
            return key;
        ulong name = 17;
        for (int at = 0; at < NameLength; at++)
            name = unchecked((name * 31) + frame.PayloadByte(NameOffset + at));
        return key | ((name & 0xFF_FFFF) << 24);
    }

    /// <summary>The class of a message between vehicles: of state each fragment counts.</summary>
    public static SendClass Of(VehicleMessageClass messageClass) => messageClass switch
    {
        VehicleMessageClass.Urgent => SendClass.Urgent,
        VehicleMessageClass.Command => SendClass.Commands,
        VehicleMessageClass.Bulk => SendClass.Bulk,
        _ => SendClass.Coordination,
    };

    private static SendClass OfTunnel(in MavlinkFrame frame)
    {
        int type = frame.PayloadByte(0) | (frame.PayloadByte(1) << 8);
        return type == ExchangeWire.PayloadType
            ? Of(ExchangeWire.ClassOf(frame.PayloadByte(TunnelOffset), frame.PayloadByte(TunnelOffset + 11)))
            : SendClass.Coordination;
    }

    private static bool IsEmergency(in MavlinkFrame frame)
    {
        if (frame.MessageId == Statustext.MavlinkId)
            return frame.PayloadByte(SeverityOffset) <= (byte)MavSeverity.Critical;
        if (frame.MessageId is not (CommandLong.MavlinkId or CommandInt.MavlinkId))
            return false;
        var command = (MavCmd)(frame.PayloadByte(CommandOffset) | (frame.PayloadByte(CommandOffset + 1) << 8));
        return command is MavCmd.NavReturnToLaunch or MavCmd.NavLand or MavCmd.DoFlighttermination;
    }
}
