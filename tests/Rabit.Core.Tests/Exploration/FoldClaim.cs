namespace Rabit.Core.Tests.Exploration;

/// <summary>The claim that two places go on alike, followed to some place behind the second one.</summary>
/// <param name="Place">A place behind the second one.</param>
/// <param name="Steps">For how many more steps the claim is watched.</param>
/// <param name="First">The first place of the claim.</param>
/// <param name="Second">The second.</param>
internal sealed record FoldClaim(CodePlace Place, int Steps, CodePlace First, CodePlace Second);
