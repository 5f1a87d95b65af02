using System.Linq;
using System.Reflection;
using Xunit;

namespace Rabit.Core.Tests.Messages;

/// <summary>Messages without references, for Visual Basic, and for the closures of F# and C#.</summary>
public sealed class OtherLanguagesTests
{
    // A parameter or result with a required modifier cannot be used by Visual Basic (error BC30643).
    [Fact, Trait("Clause", "2.2")]
    public void PostAndFetchOfAValue_InMetadata_HaveNoRequiredModifiers()
    {
        MethodInfo[] methods =
        [
            .. Overloads(typeof(MessagePublisher<>), "Post"),
            .. Overloads(typeof(MessagePublisher<>), "PostStamped"),
            .. Overloads(typeof(MessageSubscriber<>), "Fetch"),
            .. Overloads(typeof(MessageSubscriber<>), "FetchAndCountMissed"),
        ];

        Assert.Equal(7, methods.Length);
        Assert.All(methods, m => Assert.All(
            m.GetParameters().Append(m.ReturnParameter), p => Assert.Empty(p.GetRequiredCustomModifiers())));
    }

    private static MethodInfo[] Overloads(System.Type type, string name)
        => [.. type.GetMethods().Where(m => m.Name == name)];
}
