namespace Rabit.Uav.Simulation;

/// <summary>Who sent a frame: who gets the answer. A plain value.</summary>
/// <param name="systemId">System.</param>
/// <param name="componentId">Component.</param>
internal readonly struct Sender(byte systemId, byte componentId)
{
    public byte SystemId { get; } = systemId;

    public byte ComponentId { get; } = componentId;
}
