using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>
/// A line about one parameter of the autopilot. A failsafe whose value is not answered fails: it is taken to be off.
/// </summary>
internal sealed class ParameterRule : PreflightRule
{
    /// <summary>What judges a value.</summary>
    public ParameterTest Test { get; init; } = ParameterTest.Any;

    /// <summary>
    /// All names of the parameter in versions of the autopilot, each with what its value is multiplied by to be in the
    /// unit of <see cref="Test"/>.
    /// </summary>
    public IReadOnlyList<(string Name, double Scale)> Names { get; init; } = [];

    /// <summary>
    /// What <c>--set-failsafes</c> writes, in the unit of the test; null where it depends on the aircraft.
    /// </summary>
    public double? Wanted { get; init; }

    /// <summary>What is said behind the value.</summary>
    public Func<PreflightFacts, string> Note { get; init; } = _ => string.Empty;

    /// <summary>Whether it is no failsafe, so that it may be unknown: older versions are without it.</summary>
    public bool IsOptional { get; init; }

    public override string HowToSet
        => Wanted is { } wanted
            ? string.Format(
                CultureInfo.InvariantCulture, "set it to {0}{1}, or give --set-failsafes",
                Test.WantedText(wanted), Test.Meaning(wanted))
            : base.HowToSet;

    /// <summary>The same as a line of one make of autopilot.</summary>
    public ParameterRule For(MavAutopilot autopilot, bool? isOfFixedWing) => new()
    {
        Name = Name,
        Autopilot = autopilot,
        IsOfFixedWing = isOfFixedWing,
        Names = Names,
        Test = Test,
        Wanted = Wanted,
        IsOptional = IsOptional,
        Note = Note,
        Pass = Pass,
        Warn = Warn,
        Fail = Fail,
        Reason = Reason,
        HowToSet = HowToSet,
    };

    public override PreflightJudgement Judge(PreflightFacts facts)
    {
        if (!TryRead(facts.Parameters, out string name, out double value))
        {
            return IsOptional
                ? PreflightJudgement.Unknown("the autopilot did not answer")
                : PreflightJudgement.Fail("unknown: the autopilot did not answer");
        }

        string text = Test.ValueText(value) + Test.Meaning(value)
            + (string.Equals(name, Names[0].Name, StringComparison.Ordinal) ? string.Empty : " by " + name)
            + Note(facts);
        return new PreflightJudgement(Test.Judge(value, facts), text);
    }

    /// <summary>Reads the parameter by whichever name the autopilot has.</summary>
    /// <returns>Whether it is known.</returns>
    public bool TryRead(AutopilotParameters parameters, out string name, out double value)
    {
        foreach ((string candidate, double scale) in Names)
        {
            if (!parameters.TryGet(candidate, out AutopilotParameter parameter))
                continue;
            (name, value) = (candidate, parameter.Value * scale);
            return true;
        }

        (name, value) = (Names[0].Name, double.NaN);
        return false;
    }

    /// <summary>What is to be written, where the value does not pass and there is something to write.</summary>
    /// <returns>The name that the autopilot has and its new value in the autopilot's unit; null for nothing.</returns>
    public (string Name, double Value)? FindChange(PreflightFacts facts)
    {
        if (Wanted is not { } wanted || !TryRead(facts.Parameters, out string name, out double value)
            || Test.Judge(value, facts) == PreflightResult.Pass)
            return null;
        double scale = Names.First(n => string.Equals(n.Name, name, StringComparison.Ordinal)).Scale;
        return (name, Test.Change(value, wanted) / scale);
    }
}
