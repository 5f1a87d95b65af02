namespace Rabit.Uav.Communications;

/// <summary>What is to be sent now. A plain value.</summary>
internal struct ExchangeDatagram
{
    public int Length;

    /// <summary>The system that the frame is addressed to; 0 for all, also where others are to relay it.</summary>
    public byte TargetSystem;

    public VehicleMessageClass Class;

    /// <summary>The links that it is for, a bit for each; 0 for all that lead there and have room.</summary>
    public ulong Links;
}
