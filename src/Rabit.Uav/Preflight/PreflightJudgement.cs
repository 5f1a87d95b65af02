using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>What a rule finds.</summary>
internal readonly record struct PreflightJudgement(PreflightResult Result, string Value)
{
    public static PreflightJudgement Pass(string value) => new(PreflightResult.Pass, value);

    public static PreflightJudgement Warn(string value) => new(PreflightResult.Warn, value);

    public static PreflightJudgement Fail(string value) => new(PreflightResult.Fail, value);

    public static PreflightJudgement Unknown(string value = "not reported") => new(PreflightResult.Unknown, value);
}
