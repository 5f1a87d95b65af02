using System;
using System.Collections;
using System.Collections.Generic;

namespace Rabit.Uav.Messages;

/// <summary>The last few of something, newest first, as an immutable list: a new one for each that comes.</summary>
/// <typeparam name="T">An immutable class.</typeparam>
public sealed class RecentItems<T> : IReadOnlyCollection<T>
    where T : class
{
    private readonly T? _newest;
    private readonly RecentItems<T>? _older;

    private RecentItems(T? newest, RecentItems<T>? older)
    {
        _newest = newest;
        _older = older;
        Count = newest is null ? 0 : 1 + (older?.Count ?? 0);
    }

    /// <summary>None yet.</summary>
    public static RecentItems<T> None { get; } = new(null, null);

    /// <summary>How many are kept.</summary>
    public int Count { get; }

    /// <summary>The newest; null when there is none.</summary>
    public T? Newest => _newest;

    /// <summary>The same with one more, without the oldest where that would be too many.</summary>
    /// <param name="item">The new one.</param>
    /// <param name="atMost">How many to keep; at least 1.</param>
    public RecentItems<T> With(T item, int atMost)
    {
        if (item is null)
            throw new ArgumentNullException(nameof(item));
        if (atMost < 1)
            throw new ArgumentOutOfRangeException(nameof(atMost), atMost, "At least one item is kept.");
        return new RecentItems<T>(item, Take(atMost - 1));
    }

    /// <summary>Newest first.</summary>
    public IEnumerator<T> GetEnumerator()
    {
        for (RecentItems<T>? items = this; items?._newest is { } item; items = items._older)
            yield return item;
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    private RecentItems<T>? Take(int count) => count switch
    {
        _ when _newest is null || count == 0 => null,
        _ when count >= Count => this,
        _ => new RecentItems<T>(_newest, _older?.Take(count - 1)),
    };
}
