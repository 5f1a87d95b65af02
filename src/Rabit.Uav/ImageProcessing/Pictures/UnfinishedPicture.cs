using System;
using System.IO;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A file of a camera's folder that could not be read, perhaps because its program is still writing it: whether it is
/// worth another try. One thread.
/// </summary>
internal sealed class UnfinishedPicture
{
    /// <summary>From one look at the file to the next.</summary>
    public static readonly TimeSpan Period = TimeSpan.FromMilliseconds(100);

    // A card that is slow to write may take a second between two parts of a picture; and a file that is written for
    // ever, as a film is, is none.
    private const int MaxLooksAlike = 10;
    private const int MaxLooks = 100;

    private readonly string _path;
    private FileState _state;
    private TimeSpan _next;
    private int _looks;
    private int _looksAlike;

    /// <summary>Begins with what was seen before the file was read.</summary>
    /// <param name="path">The file.</param>
    /// <param name="picture">What it is, where that is known without reading it.</param>
    /// <param name="before">How it was before it was read.</param>
    /// <param name="reason">Why it could not be read.</param>
    /// <param name="now">By the clock of the run.</param>
    public UnfinishedPicture(string path, ListedPicture? picture, FileState before, string reason, TimeSpan now)
        => (_path, Picture, _state, Reason, _next) = (path, picture, before, reason, now + Period);

    /// <summary>What it is; null where only its EXIF says it.</summary>
    public ListedPicture? Picture { get; }

    /// <summary>The name of its file.</summary>
    public string File => Path.GetFileName(_path);

    /// <summary>Why it could not be read last.</summary>
    public string Reason { get; set; }

    /// <summary>Whether it has not changed for a second, or has been tried for ten.</summary>
    public bool IsGivenUp => _looksAlike >= MaxLooksAlike || _looks >= MaxLooks;

    /// <summary>Whether the next look is due.</summary>
    public bool IsDue(TimeSpan now) => now >= _next;

    /// <summary>Looks at the file.</summary>
    /// <returns>Whether it has changed since it was last read, so that it is worth another try.</returns>
    public bool Look(TimeSpan now)
    {
        _next = now + Period;
        _looks++;
        FileState state = FileState.Of(_path);
        if (state.Equals(_state))
        {
            _looksAlike++;
            return false;
        }

        (_state, _looksAlike) = (state, 0);
        return true;
    }
}
