using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>A rule of the pre-flight checklist, for people. Immutable.</summary>
/// <param name="Name">Name of the line, by which it is overridden.</param>
/// <param name="Autopilot">The make that has the line; null for all.</param>
/// <param name="Pass">What passes.</param>
/// <param name="Warn">What warns; empty where nothing does.</param>
/// <param name="Fail">What fails; empty where nothing does.</param>
/// <param name="Set">What <c>--set-failsafes</c> writes; empty where it writes nothing.</param>
/// <param name="Reason">Why the line is there.</param>
public sealed record PreflightRuleInfo(
    string Name, MavAutopilot? Autopilot, string Pass, string Warn, string Fail, string Set, string Reason);
