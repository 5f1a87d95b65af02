namespace Rabit.Mavlink;

/// <summary>Who somebody is on a MAVLink network. A plain value.</summary>
/// <param name="SystemId">System id, 1 to 255.</param>
/// <param name="ComponentId">Component id, 1 to 255; 0 is every component of the system.</param>
public readonly record struct MavlinkAddress(byte SystemId, byte ComponentId)
{
    /// <summary>Whether a frame comes from here; component 0 takes in all components.</summary>
    internal bool IsSourceOf(in MavlinkFrame frame) =>
        frame.SystemId == SystemId && (ComponentId == 0 || frame.ComponentId == ComponentId);

    /// <summary>Whether a message with these address fields is for this component; 0 is everybody.</summary>
    internal bool IsMeantBy(byte targetSystem, byte targetComponent) =>
        (targetSystem == 0 || targetSystem == SystemId) && (targetComponent == 0 || targetComponent == ComponentId);
}
