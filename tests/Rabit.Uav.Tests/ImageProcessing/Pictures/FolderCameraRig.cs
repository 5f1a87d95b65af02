using System;
using System.Collections.Generic;
using System.IO;
using Rabit.Core;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision.Tests.Pictures;

namespace Rabit.Uav.Tests.ImageProcessing.Pictures;

/// <summary>
/// A folder that is watched as a camera, in virtual time that begins at <see cref="StartUtc"/>, and a manager that
/// takes its pictures.
/// </summary>
internal sealed class FolderCameraRig : IDisposable
{
    public static readonly DateTimeOffset StartUtc = new(2026, 5, 4, 12, 0, 0, TimeSpan.Zero);

    private readonly SamplePictures.TemporaryFolder _folder = new();
    private readonly PictureFolderWriter _writer;
    private readonly BufferPool _pool = new("test", 1, SamplePictures.Width * SamplePictures.Height * 3);
    private RabitReactor? _reactor;

    public FolderCameraRig(int buffers = 6, PixelFormat format = PixelFormat.Rgb24)
    {
        var model = new CameraModel
        {
            Width = SamplePictures.Width,
            Height = SamplePictures.Height,
            Format = format,
            FocalX = 5,
            FocalY = 5,
            CentreX = 1.5,
            CentreY = 2
        };
        Folder = CameraFolder.Create(_folder.Path, model, new CameraMount());
        _writer = new PictureFolderWriter(Folder);
        Camera = new FolderCamera(Folder, buffers);
    }

    public CameraFolder Folder { get; private set; }

    public FolderCamera Camera { get; private set; }

    /// <summary>What came: when, and what.</summary>
    public List<(TimeSpan Time, CameraFrame Frame, byte[] Pixels)> Taken { get; } = [];

    /// <summary>Whether the pictures that come are kept, instead of given back.</summary>
    public bool KeepsPictures { get; set; }

    /// <summary>Adds a key to the description of the camera and reads it again, before the run.</summary>
    /// <param name="key">As it stands in the file, with its value; nothing if empty.</param>
    public void Describe(string key)
    {
        string file = PathOf(CameraFolder.DescriptionFile);
        string json = File.ReadAllText(file).TrimEnd();
        File.WriteAllText(file, key.Length == 0 ? json : json.Insert(json.Length - 1, ", " + key));
        Reopen();
    }

    /// <summary>Reads the description of the camera again, before the run.</summary>
    public void Reopen()
    {
        Folder = CameraFolder.Open(Folder.Path);
        Camera = new FolderCamera(Folder);
    }

    public string PathOf(string name) => _folder.File(name);

    /// <summary>Ends the run.</summary>
    public void Stop()
    {
        _reactor?.Stop();
        _reactor?.Finish();
        _reactor = null;
    }

    /// <summary>Writes a picture as another program does.</summary>
    /// <param name="number">Its number, which is also the first byte of it.</param>
    /// <param name="start">Start of its exposure since the start of the run; may be negative.</param>
    public string Write(long number, TimeSpan start)
    {
        if (!_pool.TryRent("rig", out BufferLease lease))
            throw new InvalidOperationException("The buffer of the rig was not given back.");
        using (lease)
        {
            Array.Copy(SamplePictures.Pixels(), lease.Array, lease.Array.Length);
            lease.Array[0] = (byte)number;
            return _writer.Write(
                new CameraFrame
                {
                    Pixels = lease,
                    Width = SamplePictures.Width,
                    Height = SamplePictures.Height,
                    Number = number,
                    Exposure = TimeSpan.FromMilliseconds(2)
                },
                StartUtc + start);
        }
    }

    /// <summary>Starts if nothing runs yet, and goes on.</summary>
    public void RunFor(TimeSpan time)
    {
        if (_reactor is null)
        {
            _reactor = new RabitReactor(
                new ReactorOptions { Time = new VirtualTime(1, StartUtc), StopsOnSignals = false })
            {
                new Taker(this)
            };
            _reactor.Start();
        }

        _reactor.RunFor(time);
    }

    public void Dispose()
    {
        Stop();
        _folder.Dispose();
    }

    private sealed class Taker : RabitManager
    {
        private readonly FolderCameraRig _rig;
        private readonly BlockingReader<CameraFrame> _reader;

        public Taker(FolderCameraRig rig)
            : base("taker")
        {
            _rig = rig;
            _reader = AttachReader("camera", rig.Camera, capacity: 50);
        }

        protected override void ExecuteUnitOfWork()
        {
            while (_reader.TryPop(out CameraFrame frame))
            {
                _rig.Taken.Add((Now, frame, frame.Pixels.Span.Slice(0, frame.Width * frame.Height * 3).ToArray()));
                if (!_rig.KeepsPictures)
                    frame.Dispose();
            }
        }
    }
}
