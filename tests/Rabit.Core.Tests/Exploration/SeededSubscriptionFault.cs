namespace Rabit.Core.Tests.Exploration;

/// <summary>Faults that the exploration of a subscription's end must find.</summary>
public enum SeededSubscriptionFault
{
    None,

    /// <summary>It is marked as joined first and listed then: an end in between finds nothing to take out.</summary>
    JoinedBeforeItIsListed,

    /// <summary>What has ended before it joined stays listed.</summary>
    EndedStaysListed,

    /// <summary>The end looks whether it has joined, and then writes.</summary>
    EndWithoutAnExchange,

    /// <summary>The join looks whether it has ended, and then writes.</summary>
    JoinWithoutASwap,

    /// <summary>Posters go by the list alone.</summary>
    PostersDoNotAsk,
}
