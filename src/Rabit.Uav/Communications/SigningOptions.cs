using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// Which links are signed, and how (MAVLink guide, "Message signing"; docs/concepts/signing.md). Read once, when the
/// manager is made.
/// </summary>
/// <example>
/// <code>
/// using MavlinkSigningKey key = SigningKeyFile.Read("/var/lib/my-aircraft/key");
/// options.Signing = new SigningOptions(key)
/// {
///     Links = [1],
///     TimestampStore = new FileTimestampStore("/var/lib/my-aircraft/signing"),
/// };
/// </code>
/// </example>
/// <param name="key">The secret, the same for all links; its owner disposes of it, after the run.</param>
/// <exception cref="ArgumentNullException">No key: nothing is ever signed without one.</exception>
public sealed class SigningOptions(MavlinkSigningKey key)
{
    /// <summary>The secret.</summary>
    public MavlinkSigningKey Key { get; } = key ?? throw new ArgumentNullException(nameof(key));

    /// <summary>
    /// The numbers of the live links that are signed; null for all of them. The others, a cable for example, are
    /// neither signed nor verified.
    /// </summary>
    /// <value>The default is null.</value>
    public IReadOnlyList<int>? Links { get; set; }

    /// <summary>
    /// The secrets of single links, by their numbers, where they are others than <see cref="Key"/>; their owner
    /// disposes of them, after the run. A link that has one is signed, whether or not <see cref="Links"/> has it.
    /// </summary>
    /// <value>The default is none.</value>
    public IReadOnlyDictionary<int, MavlinkSigningKey> LinkKeys { get; set; }
        = new Dictionary<int, MavlinkSigningKey>();

    /// <summary>
    /// The link id in the signatures of link 0; that of link n is n more. Receivers remember the newest time stamp per
    /// link id.
    /// </summary>
    /// <value>The default is 0.</value>
    public byte FirstLinkId { get; set; }

    /// <summary>Which unsigned frames pass on signed links.</summary>
    /// <value>The default is <see cref="MavlinkVerifier.RadioStatusOnly"/>.</value>
    public MavlinkUnsignedRule AcceptUnsigned { get; set; } = MavlinkVerifier.RadioStatusOnly;

    /// <summary>
    /// Where the signing clock is stored, so that a restart does not go back; null for nowhere. Written on a thread of
    /// its own, about every 30 s.
    /// </summary>
    /// <value>The default is null.</value>
    public IMavlinkTimestampStore? TimestampStore { get; set; }

    /// <summary>These, with keys of single links beside those that are there.</summary>
    internal static SigningOptions? With(SigningOptions? options, IReadOnlyDictionary<int, MavlinkSigningKey> keys)
    {
        if (keys.Count == 0)
            return options;
        if (options is null)
            return new SigningOptions(keys.Values.First()) { Links = [], LinkKeys = keys };
        return new SigningOptions(options.Key)
        {
            Links = options.Links,
            LinkKeys = options.LinkKeys.Where(k => !keys.ContainsKey(k.Key)).Concat(keys)
                .ToDictionary(k => k.Key, k => k.Value),
            FirstLinkId = options.FirstLinkId,
            AcceptUnsigned = options.AcceptUnsigned,
            TimestampStore = options.TimestampStore,
        };
    }

    internal IEnumerable<string> FindFaults(int liveLinks)
    {
        if (LinkKeys is null || LinkKeys.Values.Contains(null!))
            yield return $"{nameof(LinkKeys)}, or one of them, is null; it may be empty, but not null";
        foreach (int link in (Links ?? []).Concat(LinkKeys?.Keys ?? []).Where(l => l < 0 || l >= liveLinks))
            yield return $"link {link} is to be signed, but there are {liveLinks} live links, numbered from 0";
        if (liveLinks > 0 && FirstLinkId + liveLinks - 1 > byte.MaxValue)
            yield return $"{nameof(FirstLinkId)} is {FirstLinkId}, and there are {liveLinks} live links; link ids end "
                + $"at {byte.MaxValue}";
        if (AcceptUnsigned is null)
            yield return $"{nameof(AcceptUnsigned)} is null";
    }
}
