using System.Text;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Preflight;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>docs/preflight.md has the lines of the checklist as the rules judge them.</summary>
public sealed class PreflightPageTests
{
    [Fact]
    public void Table_OfTheLines_IsThatOfTheRules()
        => GeneratedBlock.AssertUpToDate("docs/preflight.md", "preflight", Render());

    private static string Render()
    {
        var text = new StringBuilder(
            "| line | of | passes | warns | fails | is set to | why |\n|---|---|---|---|---|---|---|\n");
        foreach (PreflightRuleInfo rule in PreflightRules.All)
        {
            string of = rule.Autopilot switch
            {
                MavAutopilot.Ardupilotmega => "ArduPilot",
                MavAutopilot.Px4 => "PX4",
                _ => "all",
            };
            text.Append(
                $"| `{rule.Name}` | {of} | {rule.Pass} | {rule.Warn} | {rule.Fail} | {rule.Set} | {rule.Reason} |\n");
        }

        return text.ToString();
    }
}
