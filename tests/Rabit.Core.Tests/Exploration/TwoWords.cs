using Rabit.Core.Messages;

namespace Rabit.Core.Tests.Exploration;

/// <summary>A slot with a value of two plain words.</summary>
internal sealed class TwoWords : Slot
{
    public int First;
    public int Second;
}
