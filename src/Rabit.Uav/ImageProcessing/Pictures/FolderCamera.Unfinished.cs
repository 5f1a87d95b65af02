using System.Collections.Generic;
using System.IO;
using System.Threading;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <content>Pictures that cannot be read yet, since their program is still writing them.</content>
public sealed partial class FolderCamera
{
    // Of those whose time only their EXIF says.
    private const int MaxUnfinished = 16;

    private readonly List<UnfinishedPicture> _unfinishedExif = [];
    private UnfinishedPicture? _unfinished;   // the one whose time has come

    private bool TryTake(ListedPicture picture, out CameraFrame frame)
    {
        string path = Path.Combine(_folder.Path, picture.File);
        FileState before = picture.IsNew ? FileState.Of(path) : default;
        if (TryRead(picture, out frame, out string? reason))
            return true;
        if (reason is not null && picture.IsNew)
            _unfinished = new UnfinishedPicture(path, picture, before, reason, _context!.Now);
        else if (reason is not null)
            Refuse(reason);
        return false;
    }

    // Nothing is held up by it: when the next picture's time has come, this is its last chance.
    private bool TryTakeUnfinished(bool isLast, out CameraFrame frame)
    {
        frame = default;
        if (_unfinished is not { } unfinished || (!isLast && !unfinished.IsDue(_context!.Now)))
            return false;
        string? reason = unfinished.Reason;
        bool isTaken = unfinished.Look(_context!.Now) && TryRead(unfinished.Picture!, out frame, out reason);
        unfinished.Reason = reason ?? unfinished.Reason;
        if (isTaken)
            Interlocked.Increment(ref _readAgain);
        else if (reason is not null && (isLast || unfinished.IsGivenUp))
            Refuse(reason);
        if (isTaken || isLast || reason is null || unfinished.IsGivenUp)
            _unfinished = null;
        return isTaken;
    }

    private void ReadExif(string name, List<ListedPicture> found)
    {
        string path = Path.Combine(_folder.Path, name);
        FileState before = _hasListed ? FileState.Of(path) : default;
        if (TryReadExif(name, found, out string reason))
            return;
        if (!_hasListed)
        {
            Refuse(reason);
            return;
        }

        if (_unfinishedExif.Count == MaxUnfinished)
        {
            Refuse(_unfinishedExif[0].Reason);
            _unfinishedExif.RemoveAt(0);
        }

        _unfinishedExif.Add(new UnfinishedPicture(path, null, before, reason, _context!.Now));
    }

    private void ReadUnfinishedExif(List<ListedPicture> found)
    {
        for (int at = _unfinishedExif.Count - 1; at >= 0; at--)
        {
            UnfinishedPicture unfinished = _unfinishedExif[at];
            if (!unfinished.IsDue(_context!.Now))
                continue;
            string reason = unfinished.Reason;
            bool isRead = unfinished.Look(_context.Now) && TryReadExif(unfinished.File, found, out reason);
            unfinished.Reason = reason;
            if (isRead)
                Interlocked.Increment(ref _readAgain);
            else if (unfinished.IsGivenUp)
                Refuse(reason);
            if (isRead || unfinished.IsGivenUp)
                _unfinishedExif.RemoveAt(at);
        }
    }

    private void GiveUpUnfinished()
    {
        foreach (UnfinishedPicture unfinished in _unfinishedExif)
            Refuse(unfinished.Reason);
        _unfinishedExif.Clear();
        if (_unfinished is { } last)
            Refuse(last.Reason);
        _unfinished = null;
    }

    private bool TryReadExif(string name, List<ListedPicture> found, out string reason)
    {
        try
        {
            found.Add(PictureExif.Read(_folder, name));
            reason = string.Empty;
            return true;
        }
        catch (PictureException e)
        {
            reason = e.Message;
            return false;
        }
    }
}
