using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A camera that is a folder of pictures with their times, also one that grows while it is watched: what another
/// program takes, this reads. It never blocks: real time waits for a picture, virtual time jumps to the end of its
/// exposure.
/// </summary>
/// <remarks>
/// The times are those of the wall clock and are taken over into the clock of the run by what that says of both; so
/// pictures of a recorded flight go with a recorded log whose start the clock of the run was set to. Pictures come in
/// the order of their times. The figures may be read from any thread.
/// </remarks>
public sealed partial class FolderCamera : ICamera
{
    private static readonly TimeSpan Poll = UnfinishedPicture.Period;

    // Clocks of two computers may differ a little. What appears during the run and is further ahead has not been taken
    // yet by our clock: its stamp is wrong.
    private static readonly TimeSpan MaxAhead = TimeSpan.FromSeconds(1);

    private readonly CameraFolder _folder;
    private readonly PictureListing _listing;
    private readonly BufferPool _pool;
    private readonly List<ListedPicture> _pending = [];   // the next is the last
    private readonly List<string> _nameless = [];
    private readonly PictureReader _reader = new();
    private string _timeSource;   // written by the reader, read by any
    private TimeSpan _exifNoise;
    private long _lastNumber = -1;
    private ReaderContext? _context;
    private long _openedUtc;
    private long _lastUtc = long.MinValue;
    private long _delivered;
    private long _refused;
    private long _beforeRun;
    private long _late;
    private long _withoutBuffer;
    private long _ahead;
    private long _readAgain;
    private string? _lastRefusal;
    private string? _fault;
    private bool _hasListed;

    /// <summary>Makes the camera.</summary>
    /// <param name="folder">The folder, see <see cref="CameraFolder.Open"/>.</param>
    /// <param name="buffers">
    /// How many pictures may be on their way at once, at least 1; while all buffers are out, pictures are lost.
    /// </param>
    public FolderCamera(CameraFolder folder, int buffers = 6)
    {
        _folder = folder ?? throw new ArgumentNullException(nameof(folder));
        _listing = new PictureListing(folder);
        _timeSource = PictureTimeSource.Describe("names of the pictures or camera.json", folder.TimeNoise);
        _pool = new BufferPool("camera " + folder.Path, buffers, folder.Camera.Width * folder.Camera.Height * 3);
    }

    /// <inheritdoc/>
    public bool Blocks => false;

    /// <inheritdoc/>
    public string Name => "folder";

    /// <inheritdoc/>
    public CameraStatistics Statistics => new()
    {
        Delivered = PicturesDelivered,
        Refused = PicturesRefused,
        WithoutBuffer = PicturesWithoutBuffer,
        BeforeRun = PicturesBeforeRun,
        Late = PicturesLate,
        Ahead = PicturesAhead,
        TimeSource = Volatile.Read(ref _timeSource),
        Fault = Volatile.Read(ref _fault),
        LastFault = LastRefusal,
    };

    /// <summary>Pictures delivered.</summary>
    public long PicturesDelivered => Interlocked.Read(ref _delivered);

    /// <summary>
    /// Pictures that could not be read, have another size than the camera's, or neither a name nor EXIF with their
    /// time.
    /// </summary>
    public long PicturesRefused => Interlocked.Read(ref _refused);

    /// <summary>Pictures that were begun before the reader was opened, and were therefore not read.</summary>
    public long PicturesBeforeRun => Interlocked.Read(ref _beforeRun);

    /// <summary>Pictures that appeared when a later one had already been delivered, and were not read.</summary>
    public long PicturesLate => Interlocked.Read(ref _late);

    /// <summary>
    /// Pictures whose time is more than a second ahead of the wall clock, and that were not read: the clock that
    /// stamped them is wrong. <see cref="LastRefusal"/> names the last one.
    /// </summary>
    public long PicturesAhead => Interlocked.Read(ref _ahead);

    /// <summary>
    /// Pictures that could not be read at first, since they were still being written, and were whole at a later try.
    /// </summary>
    public long PicturesReadAgain => Interlocked.Read(ref _readAgain);

    /// <summary>Pictures lost because no buffer was free.</summary>
    public long PicturesWithoutBuffer => Interlocked.Read(ref _withoutBuffer);

    /// <summary>
    /// Why the last picture that was refused was, or why the folder cannot be read, one line; null if nothing happened.
    /// </summary>
    public string? LastRefusal => Volatile.Read(ref _lastRefusal);

    /// <inheritdoc/>
    public void LogTo(Action<string>? log)
    {
        // What happens to a folder is in its figures.
    }

    /// <inheritdoc/>
    public void Open(ReaderContext context)
    {
        _context = context ?? throw new ArgumentNullException(nameof(context));
        _openedUtc = PictureFolderWriter.ToMicroseconds(context.Clock.GetUtcNow());
        foreach (ListedPicture picture in _folder.Listed)
            Add(picture);
        Sort();
    }

    /// <inheritdoc/>
    public ReaderStep Read(out CameraFrame value)
    {
        value = default;
        while (true)
        {
            // While one is waited for, earlier ones may appear.
            if (!IsNextDue(out TimeSpan wait))
                FindNew();
            bool isNextDue = IsNextDue(out wait);
            if (TryTakeUnfinished(isNextDue, out value))
                return ReaderStep.Value;
            if (!isNextDue)
                return ReaderStep.WaitUntil(_context!.Now + (wait < Poll ? wait : Poll));

            ListedPicture next = _pending[_pending.Count - 1];
            _pending.RemoveAt(_pending.Count - 1);
            _lastUtc = next.Facts.StartUtcMicroseconds;
            if (TryTake(next, out value))
                return ReaderStep.Value;
        }
    }

    /// <inheritdoc/>
    public void Unblock()
    {
    }

    /// <inheritdoc/>
    public void Close() => GiveUpUnfinished();

    private bool IsNextDue(out TimeSpan wait)
    {
        wait = Poll;
        if (_pending.Count == 0)
            return false;
        ListedPicture next = _pending[_pending.Count - 1];
        wait = RunTime(next.Facts.StartUtcMicroseconds) + ExposureOf(next) - _context!.Now;
        return wait <= TimeSpan.Zero;
    }

    private static TimeSpan ExposureOf(ListedPicture picture)
        => TimeSpan.FromTicks(picture.Facts.ExposureMicroseconds * PictureFolderWriter.TicksPerMicrosecond);

    // The reason is null where a buffer is what is missing.
    private bool TryRead(ListedPicture picture, out CameraFrame frame, out string? reason)
    {
        (frame, reason) = (default, null);
        if (!_pool.TryRent("folder camera", out BufferLease lease))
        {
            Interlocked.Increment(ref _withoutBuffer);
            return false;
        }

        try
        {
            Load(Path.Combine(_folder.Path, picture.File), lease.Array);
        }
        catch (PictureException e)
        {
            lease.Dispose();
            reason = e.Message;
            return false;
        }

        // EXIF has no numbers, so none is missing.
        _lastNumber = picture.ExifNoise is null ? picture.Facts.Number : _lastNumber + 1;
        frame = new CameraFrame
        {
            Pixels = lease,
            Width = _folder.Camera.Width,
            Height = _folder.Camera.Height,
            Format = _folder.Camera.Format,
            Number = _lastNumber,
            FrameStart = RunTime(picture.Facts.StartUtcMicroseconds),
            Exposure = ExposureOf(picture),
            TimeNoise = NoiseOf(picture),
        };
        Interlocked.Increment(ref _delivered);
        return true;
    }

    private TimeSpan NoiseOf(ListedPicture picture)
    {
        if (picture.ExifNoise is not { } rounding)
            return _folder.TimeNoise;
        double clock = _folder.TimeNoise.ExactSeconds;
        double seconds = Math.Sqrt((clock * clock) + (rounding.ExactSeconds * rounding.ExactSeconds));
        var noise = TimeSpan.FromTicks((long)(seconds * TimeSpan.TicksPerSecond));
        if (noise != _exifNoise)
            Volatile.Write(ref _timeSource, PictureTimeSource.Describe("EXIF of the pictures", _exifNoise = noise));
        return noise;
    }

    private void Load(string path, byte[] pixels)
    {
        (int width, int height) = (_folder.Camera.Width, _folder.Camera.Height);
        if (_folder.Camera.Format == PixelFormat.Grey16)
            _reader.LoadCountsInto(path, width, height, MemoryMarshal.Cast<byte, ushort>(pixels.AsSpan()));
        else
            _reader.LoadInto(path, width, height, pixels);
    }

    private void FindNew()
    {
        var found = new List<ListedPicture>();
        try
        {
            _listing.FindNew(found, _nameless);
            Volatile.Write(ref _fault, null);
        }
        catch (PictureException e)
        {
            Volatile.Write(ref _lastRefusal, e.Message);
            Volatile.Write(ref _fault, e.Message);
        }

        ReadUnfinishedExif(found);
        foreach (string name in _nameless)
            ReadExif(name, found);
        _nameless.Clear();
        foreach (ListedPicture picture in found)
        {
            picture.IsNew = _hasListed;

            // Those of a recorded folder are there from the start, and come at their times.
            if (_hasListed && RunTime(picture.Facts.StartUtcMicroseconds) - _context!.Now > MaxAhead)
                RefuseAhead(picture);
            else
                Add(picture);
        }

        _hasListed = true;
        Sort();
    }

    private void Add(ListedPicture picture)
    {
        if (picture.Facts.StartUtcMicroseconds < _openedUtc)
            Interlocked.Increment(ref _beforeRun);
        else if (picture.Facts.StartUtcMicroseconds <= _lastUtc)
            Interlocked.Increment(ref _late);
        else
            _pending.Add(picture);
    }

    // Latest first; among pictures of the same time the order of the names, so that no file system's order is seen.
    private void Sort() => _pending.Sort((a, b) =>
    {
        int order = b.Facts.StartUtcMicroseconds.CompareTo(a.Facts.StartUtcMicroseconds);
        return order != 0 ? order : string.CompareOrdinal(b.File, a.File);
    });

    private void RefuseAhead(ListedPicture picture)
    {
        Interlocked.Increment(ref _ahead);
        TimeSpan ahead = RunTime(picture.Facts.StartUtcMicroseconds) - _context!.Now;
        Volatile.Write(ref _lastRefusal, FormattableString.Invariant(
            $"{Path.Combine(_folder.Path, picture.File)}: its time is {ahead.ExactSeconds:0.0} s ahead of the clock"));
    }

    private void Refuse(string reason)
    {
        Interlocked.Increment(ref _refused);
        Volatile.Write(ref _lastRefusal, reason);
    }

    private TimeSpan RunTime(long utcMicroseconds)
    {
        TimeSpan sinceEpoch = TimeSpan.FromTicks(utcMicroseconds * PictureFolderWriter.TicksPerMicrosecond);
        return _context!.Now + (sinceEpoch - (_context.Clock.GetUtcNow() - PictureFolderWriter.Epoch));
    }
}
