namespace Rabit.Core.Tests.Exploration;

/// <summary>A fault that is put into <see cref="FaultySlots"/>, for the explorer to find.</summary>
public enum SeededSlotFault
{
    /// <summary>None: what is left is right.</summary>
    None,

    /// <summary>A fetcher whose tries were all spoilt by posts tries on, for as long as posts spoil them.</summary>
    NeverPins,

    /// <summary>A fetcher that has pinned does not look whether the slot is still the latest.</summary>
    PinWithoutARecheck,

    /// <summary>A fetcher checks again, but before it pins.</summary>
    RecheckBeforeThePin,

    /// <summary>A fetcher lets go of the slot before it has copied the value.</summary>
    UnpinBeforeTheCopy,

    /// <summary>A poster writes a spare without a look at its pins.</summary>
    SpareTakenThoughPinned,

    /// <summary>A poster writes the version of a slot after its value, not before.</summary>
    VersionAfterTheValue,

    /// <summary>The value may be seen before the version that spoils what was there.</summary>
    NoStoreBarrier,

    /// <summary>The version may be read before the value.</summary>
    NoLoadBarrier,

    /// <summary>Several posters write the word without a swap.</summary>
    NoSwap,

    /// <summary>A poster that is alone never publishes with a fence.</summary>
    DemandIgnored,

    /// <summary>A fetcher that demands fences makes none for all threads.</summary>
    DemandWithoutAFence,

    /// <summary>A fetcher that finds another one at its slot lets go and pins again.</summary>
    PinsAlone,
}
