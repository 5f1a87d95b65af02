using Rabit.Core.Messages;

namespace Rabit.Core.Tests.Exploration;

/// <summary>Slots of a message whose values are two words: those of the library, or a twin with a fault.</summary>
internal abstract class SlotsUnderTest
{
    /// <returns>The version.</returns>
    public abstract int Store(int value, SpareSlots spares);

    /// <param name="fetched">The value, and how often one was copied until it was whole.</param>
    /// <returns>The version.</returns>
    public abstract int Load(out TwoWordsCopier fetched);

    /// <summary>The word that names the latest slot.</summary>
    public abstract ref long Latest { get; }
}
