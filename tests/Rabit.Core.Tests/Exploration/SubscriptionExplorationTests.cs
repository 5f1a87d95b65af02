using Xunit;
using Xunit.Abstractions;

namespace Rabit.Core.Tests.Exploration;

/// <summary>Contract 2.6 in every interleaving of the end of a subscription, its start, other ends and posts.</summary>
public sealed class SubscriptionExplorationTests(ITestOutputHelper output)
{
    [Theory, Trait("Clause", "2.6")]
    [InlineData("SequentiallyConsistent", 0, 1, 1)]
    [InlineData("SequentiallyConsistent", 2, 2, 2)]
    [InlineData("StoreBuffers", 2, 2, 2)]
    [InlineData("Weak", 1, 2, 2)]
    [InlineData("Weak", 2, 1, 2)]
    public void End_WhileItJoinsAndPostsGoOn_IsTheEnd(string memory, int enders, int posters, int posts)
    {
        ExplorationResult result = Explore(memory, new ProductionSubscription(), enders, posters, posts);

        output.WriteLine(result.ToString());
        Assert.True(result.Fault is null, result.ToString());
    }

    /// <summary>That the exploration finds what it is for.</summary>
    [Theory]
    [InlineData(SeededSubscriptionFault.JoinedBeforeItIsListed)]
    [InlineData(SeededSubscriptionFault.EndedStaysListed)]
    [InlineData(SeededSubscriptionFault.EndWithoutAnExchange)]
    [InlineData(SeededSubscriptionFault.JoinWithoutASwap)]
    [InlineData(SeededSubscriptionFault.PostersDoNotAsk)]
    public void Exploration_OfATwinWithAFault_FindsIt(SeededSubscriptionFault fault)
    {
        ExplorationResult right = Explore("Weak", new FaultySubscription(SeededSubscriptionFault.None), 1, 1, 1);
        ExplorationResult wrong = Explore("Weak", new FaultySubscription(fault), 1, 1, 1);

        output.WriteLine(wrong.ToString());
        Assert.True(right.Fault is null, right.ToString());
        Assert.NotNull(wrong.Fault);
    }

    private static ExplorationResult Explore(
        string memory, SubscriptionUnderTest subscription, int enders, int posters, int posts)
        => Explorer.Explore(
            new SubscriptionModel(subscription, enders, posters, posts),
            new ExplorerOptions(MemoryModels.Named(memory)) { WatchedSteps = 0 });
}
