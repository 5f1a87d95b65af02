using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Mavlink.Tests.Docs;

/// <summary>
/// The examples in the documentation comments compile, and the types that a user starts from have one.
/// </summary>
public class ExampleTests
{
    private static readonly Type[] StartingPoints =
    [
        typeof(MavlinkFrame), typeof(MavlinkFrameReader), typeof(MavlinkSender), typeof(MavlinkDialect),
        typeof(MavlinkSigner), typeof(MavlinkVerifier),
        typeof(TlogReader), typeof(TlogWriter), typeof(MavlinkRouter), typeof(MavlinkCommand),
        typeof(MavlinkCommandClient), typeof(MavlinkMissionClient),
        typeof(MavlinkParameterClient), typeof(MavlinkRateClient), typeof(MavlinkHeartbeatTracker),
        typeof(MavlinkHeartbeatSender),
    ];

    private static readonly IReadOnlyList<XmlDocExample> Examples = XmlDocExample.In("src/Rabit.Mavlink");

    [Fact]
    public void EveryExample_OfTheSources_Compiles() => Assert.All(Examples, example =>
    {
        IReadOnlyList<string> errors = DocumentedCodeTests.Compiler.ErrorsOf(example.Text);
        Assert.True(errors.Count == 0, $"{example}: {string.Join("\n", errors)}\n\n{example.Text}");
    });

    [Fact]
    public void StartingPoints_EachType_HasAnExample() =>
        Assert.All(StartingPoints, type => Assert.Contains(
            Examples, example => example.File.EndsWith($"/{type.Name}.cs", StringComparison.Ordinal)));

    [Fact]
    public void Payload_ReturnedFromTheScopeOfItsFrame_DoesNotCompile()
    {
        IReadOnlyList<string> errors = DocumentedCodeTests.Compiler.ErrorsOf(
            "static ReadOnlySpan<byte> Dangling() { MavlinkFrame frame = default; return frame.Payload; } "
                + "Console.WriteLine(Dangling().Length);");

        Assert.Contains(errors, error => error.Contains("CS8168", StringComparison.Ordinal)
            || error.Contains("CS8352", StringComparison.Ordinal));
        Assert.Empty(DocumentedCodeTests.Compiler.ErrorsOf(
            "static int Length(in MavlinkFrame frame) => frame.Payload.Length; Console.WriteLine(Length(default));"));
    }
}
