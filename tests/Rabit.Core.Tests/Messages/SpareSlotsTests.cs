using Rabit.Core.Messages;
using Xunit;

namespace Rabit.Core.Tests.Messages;

/// <summary>Contract 1.8: the slots that belong to one poster.</summary>
public sealed class SpareSlotsTests
{
    [Fact, Trait("Clause", "1.8")]
    public void Skip_EachInTurn_GoesRound()
    {
        var spares = new SpareSlots([3, 5, 7], isOutside: false);

        Assert.Equal([3, 5, 7, 3, 5], Turns(spares, 5));
    }

    [Fact, Trait("Clause", "1.8")]
    public void Replace_TheOneWhoseTurnItWas_ComesLast()
    {
        var spares = new SpareSlots([3, 5, 7], isOutside: false);

        spares.Replace(9);

        Assert.Equal([5, 7, 9, 5], Turns(spares, 4));
    }

    [Theory, Trait("Clause", "2.8")]
    [InlineData(true)]
    [InlineData(false)]
    public void TryEnter_WhileItIsEntered_IsRefusedToCodeOutsideManagersOnly(bool isOutside)
    {
        var spares = new SpareSlots([3], isOutside);

        Assert.True(spares.TryEnter());
        Assert.Equal(!isOutside, spares.TryEnter());
        spares.Exit();
        Assert.True(spares.TryEnter());
    }

    private static int[] Turns(SpareSlots spares, int count)
    {
        var turns = new int[count];
        for (int i = 0; i < count; i++, spares.Skip())
            turns[i] = spares.Next;
        return turns;
    }
}
