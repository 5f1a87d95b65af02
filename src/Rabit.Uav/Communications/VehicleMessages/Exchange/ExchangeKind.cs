namespace Rabit.Uav.Communications;

/// <summary>What a datagram of the exchange is.</summary>
internal enum ExchangeKind
{
    None,
    Fragment,
    Acknowledgement,
    Announcement,
}
