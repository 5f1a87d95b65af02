namespace Rabit.Mavlink;

/// <summary>The address of a component on a MAVLink network. A plain value.</summary>
/// <param name="SystemId">System id, 1 to 255.</param>
/// <param name="ComponentId">Component id, 1 to 255; 0 is every component of the system.</param>
public readonly record struct MavlinkAddress(byte SystemId, byte ComponentId)
{
    /// <summary>Whether a frame was sent from this address; component 0 is any component.</summary>
    internal bool IsSourceOf(in MavlinkFrame frame) =>
        frame.SystemId == SystemId && (ComponentId == 0 || frame.ComponentId == ComponentId);

    /// <summary>Whether a message with these target fields is for this component; 0 is broadcast.</summary>
    internal bool IsTargetOf(byte targetSystem, byte targetComponent) =>
        (targetSystem == 0 || targetSystem == SystemId) && (targetComponent == 0 || targetComponent == ComponentId);
}
