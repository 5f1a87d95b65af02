using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing.Quality;

/// <summary>The share of usable pictures of the last seconds. Fixed memory, no allocation; for one thread.</summary>
internal sealed class PictureWindow
{
    // Fewer pictures say nothing of the camera: one that is bad would be a third of them.
    public const int MinPictures = 4;

    // A manoeuvre: braking, accelerating, turning. One that lasts longer is how this flight is flown.
    private static readonly TimeSpan MaxManoeuvre = TimeSpan.FromSeconds(5);

    private const int Capacity = 128;

    private readonly TimeSpan[] _times = new TimeSpan[Capacity];
    private readonly PictureQuality[] _qualities = new PictureQuality[Capacity];
    private readonly TimeSpan _length;
    private readonly TimeSpan _maxAge;
    private readonly int[] _counts = new int[(int)PictureQuality.MotionBlurred + 1];
    private long _added;
    private TimeSpan? _manoeuvreSince;

    /// <param name="length">How long a picture counts.</param>
    /// <param name="maxAge">How long it does where there are few of them.</param>
    public PictureWindow(TimeSpan length, TimeSpan maxAge) => (_length, _maxAge) = (length, maxAge);

    /// <summary>Part of the pictures that are usable, 0 to 1; null while there are too few.</summary>
    public double? UsableShare { get; private set; }

    /// <summary>What most of the others are; usable where there are none.</summary>
    public PictureQuality MainCause { get; private set; }

    /// <summary>Part of the pictures that are of that cause, 0 to 1.</summary>
    public double CauseShare { get; private set; }

    /// <summary>Forgets all pictures.</summary>
    public void Clear()
    {
        _added = 0;
        _manoeuvreSince = null;
        (UsableShare, MainCause, CauseShare) = (null, PictureQuality.Usable, 0);
    }

    /// <summary>Adds one.</summary>
    /// <param name="quality">What became of it.</param>
    /// <param name="now">The time.</param>
    /// <param name="isByManoeuvre">Whether a manoeuvre alone is why: for some seconds it says nothing.</param>
    public void Add(PictureQuality quality, TimeSpan now, bool isByManoeuvre = false)
    {
        _manoeuvreSince = isByManoeuvre ? _manoeuvreSince ?? now : null;
        if (now - _manoeuvreSince < MaxManoeuvre)
            return;
        _times[_added % Capacity] = now;
        _qualities[_added % Capacity] = quality;
        _added++;
    }

    /// <summary>Counts those that are not too old.</summary>
    public void Update(TimeSpan now)
    {
        Array.Clear(_counts, 0, _counts.Length);
        int count = 0;
        for (long i = _added - 1; i >= 0 && i >= _added - Capacity; i--)
        {
            TimeSpan age = now - _times[i % Capacity];
            if (age > (count < MinPictures ? _maxAge : _length))
                break;
            _counts[(int)_qualities[i % Capacity]]++;
            count++;
        }

        UsableShare = count < MinPictures ? null : _counts[0] / (double)count;
        int most = 0;
        for (int cause = 1; cause < _counts.Length; cause++)
            most = _counts[cause] > (most == 0 ? 0 : _counts[most]) ? cause : most;
        MainCause = (PictureQuality)most;
        CauseShare = most == 0 ? 0 : _counts[most] / (double)count;
    }
}
