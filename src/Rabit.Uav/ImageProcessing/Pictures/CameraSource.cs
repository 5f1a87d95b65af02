namespace Rabit.Uav.ImageProcessing;

/// <summary>Where the pictures of a description come from: a program, or a video device. Immutable.</summary>
internal sealed class CameraSource
{
    /// <summary>Null for a device.</summary>
    public ProcessCameraOptions? Program { get; init; }

    /// <summary>Null for a program.</summary>
    public V4l2CameraOptions? Device { get; init; }

    public ICamera CreateCamera()
        => Device is { } device ? new V4l2Camera(device) : new ProcessCamera(Program!);
}
