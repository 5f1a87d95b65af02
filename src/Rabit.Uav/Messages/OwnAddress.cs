namespace Rabit.Uav.Messages;

/// <summary>
/// Who we are on MAVLink: the system id of the vehicle that carries us and our own component id (MAVLink guide,
/// "MAVLink identifiers"). A plain value.
/// </summary>
public struct OwnAddress
{
    /// <summary>
    /// 1 to 255; 0 while it is not known, because no autopilot was connected yet and none was configured.
    /// </summary>
    public byte SystemId { get; set; }

    /// <summary>1 to 255; 191 is MAV_COMP_ID_ONBOARD_COMPUTER.</summary>
    public byte ComponentId { get; set; }

    /// <summary>Whether we know who we are, and may send.</summary>
    public readonly bool IsKnown => SystemId != 0;
}
