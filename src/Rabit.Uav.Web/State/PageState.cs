using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;

namespace Rabit.Uav.Web.State;

/// <summary>
/// What all browsers are to know: keyed values in the order of their last change. A browser is described by one number,
/// the last change that it has, so that nothing is kept for it, and one that is slow gets the newest value of a key and
/// not all those between. One thread sets, those of the browsers read; no manager takes part.
/// </summary>
internal sealed class PageState
{
    /// <summary>The longest message, bytes.</summary>
    public const int MaxMessageBytes = 3000;

    /// <summary>The longest value: with its key and what stands around it a message holds it.</summary>
    public const int MaxValueBytes = 2800;

    private readonly Lock _gate = new();   // guards all below
    private readonly Dictionary<string, LinkedListNode<PageItem>> _items = new(StringComparer.Ordinal);
    private readonly LinkedList<PageItem> _byChange = new();   // the newest change last
    private long _lastChange;
    private bool _hasNews;
    private TaskCompletionSource _news = NewSignal();

    /// <summary>
    /// Ends at the next <see cref="Signal"/> after a change. Taken before <see cref="Fill"/> it misses none.
    /// </summary>
    public Task News
    {
        get
        {
            lock (_gate)
                return _news.Task;
        }
    }

    /// <summary>How many keys there are.</summary>
    public int Count
    {
        get
        {
            lock (_gate)
                return _items.Count;
        }
    }

    /// <summary>Sets a value; the same one as before is no change.</summary>
    /// <param name="key">Plain ASCII without quotes.</param>
    /// <param name="json">Its value.</param>
    public void Set(string key, ReadOnlySpan<byte> json)
    {
        if (json.Length > MaxValueBytes)
            throw new ArgumentException($"'{key}' has {json.Length} bytes, more than {MaxValueBytes}.", nameof(json));
        lock (_gate)
        {
            if (!_items.TryGetValue(key, out LinkedListNode<PageItem>? node))
                _items.Add(key, node = new LinkedListNode<PageItem>(new PageItem(key)));
            else if (node.Value.Value.SequenceEqual(json))
                return;
            else
                _byChange.Remove(node);
            node.Value.SetValue(json);
            node.Value.Change = ++_lastChange;
            _byChange.AddLast(node);
            _hasNews = true;
        }
    }

    /// <summary>Takes a value away: browsers get null. The key stays, for one that comes again.</summary>
    public void Remove(string key)
    {
        lock (_gate)
        {
            if (!_items.ContainsKey(key))
                return;
        }

        Set(key, "null"u8);
    }

    /// <summary>Ends the wait for news, where there are any.</summary>
    public void Signal()
    {
        TaskCompletionSource? over = null;
        lock (_gate)
        {
            if (_hasNews)
                (over, _news, _hasNews) = (_news, NewSignal(), false);
        }

        over?.TrySetResult();
    }

    /// <summary>Writes the next message of a browser: what has changed since, the oldest change first.</summary>
    /// <param name="has">The last change that it has, 0 for none; afterwards that of the message.</param>
    /// <param name="message">At least <see cref="MaxMessageBytes"/> long.</param>
    /// <param name="isComplete">Whether it has all with this message.</param>
    /// <returns>The length; 0 where nothing has changed.</returns>
    public int Fill(ref long has, Span<byte> message, out bool isComplete)
    {
        message = message[..MaxMessageBytes];
        lock (_gate)
        {
            LinkedListNode<PageItem>? next = FirstAfter(has);
            isComplete = next is null;
            if (next is null)
                return 0;
            int length = Append(message, 0, "{\"set\":{"u8);
            for (bool isFirst = true; next is not null && HasRoom(message, length, next.Value); isFirst = false)
            {
                if (!isFirst)
                    length = Append(message, length, ","u8);
                length = Append(message, length, next.Value.Key);
                length = Append(message, length, next.Value.Value);
                has = next.Value.Change;
                next = next.Next;
            }

            isComplete = next is null;
            return Append(message, length, isComplete ? "},\"complete\":true}"u8 : "},\"complete\":false}"u8);
        }
    }

    private static TaskCompletionSource NewSignal() => new(TaskCreationOptions.RunContinuationsAsynchronously);

    // From the end: what has changed is a few keys of hundreds.
    private LinkedListNode<PageItem>? FirstAfter(long change)
    {
        LinkedListNode<PageItem>? first = null;
        for (LinkedListNode<PageItem>? node = _byChange.Last; node?.Value.Change > change; node = node.Previous)
            first = node;
        return first;
    }

    private static bool HasRoom(Span<byte> message, int length, PageItem item)
        => length + 1 + item.Key.Length + item.Value.Length + "},\"complete\":false}"u8.Length <= message.Length;

    private static int Append(Span<byte> message, int length, ReadOnlySpan<byte> bytes)
    {
        bytes.CopyTo(message[length..]);
        return length + bytes.Length;
    }
}
