using System.Collections.Generic;

namespace Rabit.Mavlink.Framing;

/// <summary>
/// Message descriptions by id, found in two steps without a branch on what the id is: the 256 ids that share their
/// upper bits are a page; only pages with messages take room. Immutable, safe from any thread.
/// </summary>
internal sealed class MessageTable
{
    private const int PageBits = 8;
    private const int PageLength = 1 << PageBits;

    // Page 0 and description 0 are those of unknown ids.
    private readonly ushort[] _pages;
    private readonly ushort[] _indexes;
    private readonly MavlinkMessageInfo[] _messages;

    /// <summary>Makes a table of descriptions, no two of one id.</summary>
    public MessageTable(IReadOnlyCollection<MavlinkMessageInfo> messages)
    {
        int pages = 0;
        foreach (MavlinkMessageInfo message in messages)
            pages = System.Math.Max(pages, (message.Id >> PageBits) + 1);
        _pages = new ushort[pages];
        int used = 0;
        foreach (MavlinkMessageInfo message in messages)
        {
            if (_pages[message.Id >> PageBits] == 0)
                _pages[message.Id >> PageBits] = (ushort)++used;
        }

        _indexes = new ushort[(used + 1) * PageLength];
        _messages = new MavlinkMessageInfo[messages.Count + 1];
        int index = 0;
        foreach (MavlinkMessageInfo message in messages)
        {
            _messages[++index] = message;
            _indexes[(_pages[message.Id >> PageBits] * PageLength) + (message.Id & (PageLength - 1))] = (ushort)index;
        }
    }

    /// <summary>Where the description of an id is.</summary>
    /// <param name="messageId">Any number.</param>
    /// <returns>What <see cref="At"/> takes; 0 where the id is not known.</returns>
    public int IndexOf(int messageId)
    {
        ushort[] pages = _pages;
        uint page = (uint)messageId >> PageBits;
        return page < (uint)pages.Length ? _indexes[(pages[page] * PageLength) + (messageId & (PageLength - 1))] : 0;
    }

    /// <summary>A description; that of index 0 is <c>default</c>.</summary>
    public ref readonly MavlinkMessageInfo At(int index) => ref _messages[index];
}
