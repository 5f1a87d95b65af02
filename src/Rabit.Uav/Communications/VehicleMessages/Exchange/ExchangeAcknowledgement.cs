namespace Rabit.Uav.Communications;

/// <summary>Which fragments of a message have come. A plain value.</summary>
internal struct ExchangeAcknowledgement
{
    public byte Source;
    public byte Destination;
    public uint Id;
    public bool IsUnderstood;
    public byte Hops;
    public uint Fragments;
}
