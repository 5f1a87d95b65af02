using System.Text;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Documentation.Tests;

/// <summary>docs/managers/health-monitoring.md has the rules as the manager has them.</summary>
public sealed class HealthPageTests
{
    [Fact]
    public void Table_OfTheRules_IsThatOfTheManager()
        => GeneratedBlock.AssertUpToDate("docs/managers/health-monitoring.md", "rules", Render());

    private static string Render()
    {
        var options = new HealthOptions();
        var text = new StringBuilder(
            "| reason | level | advice in flight | when | for | ends | why |\n|---|---|---|---|---|---|---|\n");
        foreach (HealthRule rule in HealthRules.All)
        {
            double dwell = rule.Dwell(options).TotalSeconds;
            text.Append(
                $"| {rule.Reason} | {rule.Level} | {Advice(rule)} | {rule.Condition(options)} | "
                + (dwell > 0 ? System.FormattableString.Invariant($"{dwell:0.##} s") : string.Empty)
                + $" | {rule.End(options)} | {rule.Why} |\n");
        }

        return text.ToString();
    }

    private static string Advice(HealthRule rule)
    {
        string advice = rule.Advice switch
        {
            HealthAdvice.Hold => "hold",
            HealthAdvice.ReturnToLaunch => "return to launch",
            HealthAdvice.Land => "land",
            _ => string.Empty,
        };
        return rule.IsAdvisedAfterwards ? advice + ", once it is over" : advice;
    }
}
