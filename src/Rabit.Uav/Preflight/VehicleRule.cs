using System;

namespace Rabit.Uav.Preflight;

/// <summary>A line about the vehicle, the mission or this computer, judged by a function.</summary>
internal sealed class VehicleRule(Func<PreflightFacts, PreflightJudgement> judge) : PreflightRule
{
    public override PreflightJudgement Judge(PreflightFacts facts) => judge(facts);
}
