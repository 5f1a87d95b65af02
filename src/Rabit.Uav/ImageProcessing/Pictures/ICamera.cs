using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A source of pictures that says how it is, as a folder, the output of a program, a video device and the simulated
/// camera do. Image Processing takes any <see cref="IReaderSource{T}"/>; of one of these it also reports the fault and
/// writes its lines into the log of the run.
/// </summary>
public interface ICamera : IReaderSource<CameraFrame>
{
    /// <summary>What it is, for people: "folder", the name of a program or of a device.</summary>
    string Name { get; }

    /// <summary>What became of its pictures so far. Any thread.</summary>
    CameraStatistics Statistics { get; }

    /// <summary>
    /// Takes lines for people: what a program writes to its standard error, and why a camera is opened again. Any
    /// thread.
    /// </summary>
    /// <param name="log">Called from any thread, some times a second at most; null for nothing.</param>
    void LogTo(Action<string>? log);
}
