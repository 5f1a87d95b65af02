namespace Rabit.Mavlink.Signing;

/// <summary>
/// The newest time stamp of each stream, that is of each system, component and link id. Only frames with a right
/// signature get in, so that it cannot be filled without the key. Fixed memory; hashed with open addresses; nothing is
/// ever taken out.
/// </summary>
internal sealed class ReplayTable
{
    private const uint Spread = 2_654_435_769;   // 2^32 / golden ratio

    // Key and time stamp; a time stamp of -1 is a free place.
    private readonly int[] _streams;
    private readonly long[] _newest;
    private readonly int _shift;
    private readonly int _capacity;

    /// <summary>Makes room for so many streams.</summary>
    public ReplayTable(int capacity)
    {
        _capacity = capacity;
        int bits = 1;
        while ((1L << bits) < 2L * capacity)
            bits++;
        _shift = 32 - bits;
        _streams = new int[1 << bits];
        _newest = new long[1 << bits];
        for (int index = 0; index < _newest.Length; index++)
            _newest[index] = -1;
    }

    public int Count { get; private set; }

    public bool IsFull => Count == _capacity;

    /// <summary>Finds a stream.</summary>
    /// <param name="stream">The stream.</param>
    /// <param name="place">Where it is, or where it would go.</param>
    /// <returns>Its newest time stamp; -1 where it is not known.</returns>
    public long Find(int stream, out int place)
    {
        place = (int)(unchecked((uint)stream * Spread) >> _shift);
        while (_newest[place] >= 0 && _streams[place] != stream)
            place = (place + 1) & (_newest.Length - 1);
        return _newest[place];
    }

    /// <summary>Remembers a time stamp at the place that <see cref="Find"/> gave.</summary>
    public void Set(int place, int stream, long timestamp)
    {
        if (_newest[place] < 0)
            Count++;
        _streams[place] = stream;
        _newest[place] = timestamp;
    }

    public static int StreamOf(byte systemId, byte componentId, byte linkId)
        => (systemId << 16) | (componentId << 8) | linkId;
}
