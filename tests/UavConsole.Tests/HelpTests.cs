using System.CommandLine;
using System.Linq;
using Xunit;

namespace UavConsole.Tests;

/// <summary>What --help says of each option.</summary>
public sealed class HelpTests
{
    [Theory]
    [InlineData("--fly", "--link")]
    [InlineData("--fly", "--mission")]
    [InlineData("--camera", "--link")]
    [InlineData("--truth", "--fly")]
    [InlineData("--terrain", "--fly")]
    [InlineData("--hold", "--fly")]
    [InlineData("--return", "--fly")]
    [InlineData("--fixed-wing", "--fly")]
    [InlineData("--set-failsafes", "--fly")]
    [InlineData("--upload-fence", "--fly")]
    [InlineData("--originals", "--fly")]
    [InlineData("--without-detection", "--fly")]
    [InlineData("--trust-link", "--sign-key")]
    [InlineData("--offer-fence", "--fly")]
    [InlineData("--signed-commands", "--fly")]
    [InlineData("--signed-commands", "--sign-key")]
    [InlineData("--targets-as-traffic", "--fly")]
    [InlineData("--px4-events", "--link")]
    public void Description_OptionThatNeedsAnother_NamesIt(string option, string needed)
        => Assert.Contains(
            needed, CommandLineRun.Create().Options.Single(o => o.Name == option).Description);

    [Fact]
    public void Description_EveryOption_IsASentence()
        => Assert.All(
            CommandLineRun.Create().Options.Where(o => o.Name is not "--help" and not "--version"),
            (Option o) => Assert.EndsWith(".", o.Description));
}
