namespace Rabit.Mavlink;

/// <summary>Decides on frames that are not signed. Anybody who can send into the link can send such frames.</summary>
/// <param name="frame">The frame.</param>
/// <param name="link">The number of the link it came from, as given to <see cref="MavlinkVerifier.Verify"/>; for example to trust a cable.</param>
/// <returns>Whether it is accepted.</returns>
public delegate bool MavlinkUnsignedRule(in MavlinkFrame frame, int link);
