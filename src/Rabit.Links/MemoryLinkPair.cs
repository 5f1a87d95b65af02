using System;

namespace Rabit.Links;

/// <summary>
/// Two links inside the process: what is written to one end is read at the other. They never block, so that tests and
/// virtual time use them: what happens depends only on the order of the calls. Each direction holds a bounded number of
/// bytes; a write that does not fit as a whole is dropped as a whole and counted at the end that wrote, without an
/// exception, as a radio would.
/// </summary>
/// <example>
/// <code>
/// var links = new MemoryLinkPair("test");
/// links.A.Write([1, 2, 3], 0, 3);
/// LinkRead read = links.B.Read(new byte[16]);   // 3 bytes; NothingYet when there are none
/// </code>
/// </example>
public sealed class MemoryLinkPair
{
    /// <summary>Makes the two ends.</summary>
    /// <param name="name">Names the pair in errors: the ends are <c>memory:NAME/a</c> and <c>memory:NAME/b</c>.</param>
    /// <param name="capacityBytes">How many bytes may be on the way in each direction, at least 1.</param>
    /// <exception cref="ArgumentException">The name is empty or the capacity not positive.</exception>
    public MemoryLinkPair(string name, int capacityBytes = 64 * 1024)
    {
        if (string.IsNullOrWhiteSpace(name))
            throw new ArgumentException("a pair of memory links needs a name", nameof(name));
        if (capacityBytes < 1)
            throw new ArgumentOutOfRangeException(
                nameof(capacityBytes), capacityBytes, $"memory link {name} needs room for at least 1 byte");

        var a = new MemoryLink($"memory:{name}/a", capacityBytes);
        var b = new MemoryLink($"memory:{name}/b", capacityBytes);
        a.ConnectTo(b);
        b.ConnectTo(a);
        A = a;
        B = b;
    }

    /// <summary>One end.</summary>
    public IByteLink A { get; }

    /// <summary>The other end.</summary>
    public IByteLink B { get; }
}
