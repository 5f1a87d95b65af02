namespace Rabit.Uav.Communications;

/// <summary>That a vehicle is there, and in which groups. A plain value.</summary>
internal struct ExchangeAnnouncement
{
    public byte Source;
    public uint Groups;
    public byte Accuracy;
    public ushort Number;
    public byte Hops;
    public ushort Session;
}
