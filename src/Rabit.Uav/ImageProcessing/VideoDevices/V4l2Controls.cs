using System;
using System.Collections.Generic;

namespace Rabit.Uav.ImageProcessing.VideoDevices;

/// <summary>Sets exposure and focus of a device, as far as it has controls for them. Immutable.</summary>
internal sealed class V4l2Controls
{
    private const uint NotSettable = V4l2Layout.IsDisabled | V4l2Layout.IsReadOnly;
    private const long TicksPerUnit = TimeSpan.TicksPerMillisecond / 10;

    private const int MaxUnits = 100_000;   // 10 s; a driver that says more is wrong

    private readonly IVideoSystem _system;
    private readonly int _descriptor;
    private readonly List<string> _missing = [];

    public V4l2Controls(IVideoSystem system, int descriptor, V4l2CameraOptions options)
    {
        (_system, _descriptor) = (system, descriptor);
        Exposure = V4l2CameraOptions.AssumedExposure;

        // Many let the rate fall in the dark.
        TrySet(V4l2Layout.ExposureMayReduceRate, 0);
        if (options.Exposure is { } exposure)
            SetExposure(exposure);
        if (options.Focus is { } focus)
        {
            TrySet(V4l2Layout.FocusIsAutomatic, 0);
            if (!TrySet(V4l2Layout.Focus, focus))
                _missing.Add("focus");
        }
    }

    /// <summary>How long an exposure takes, as the device says or as is assumed.</summary>
    public TimeSpan Exposure { get; private set; }

    /// <summary>What was asked for and cannot be set.</summary>
    public IReadOnlyList<string> Missing => _missing;

    private void SetExposure(TimeSpan exposure)
    {
        Exposure = exposure;
        TrySet(V4l2Layout.ExposureMode, V4l2Layout.ExposureManual);
        long units = Math.Max(1, exposure.Ticks / TicksPerUnit);
        if (!TrySet(V4l2Layout.ExposureTime, (int)units))
            _missing.Add("exposure");
        else if (TryGet(V4l2Layout.ExposureTime, out int set) && set is > 0 and <= MaxUnits)
            Exposure = TimeSpan.FromTicks(set * TicksPerUnit);
    }

    // Within the limits of the device.
    private bool TrySet(uint control, int value)
    {
        byte[] query = new byte[V4l2Layout.QueryControlBytes];
        V4l2Device.Write(query, 0, control);
        if (V4l2Device.Control(_system, _descriptor, V4l2Layout.QueryControl, query) < 0
            || (V4l2Device.Read(query, V4l2Layout.ControlFlagsAt) & NotSettable) != 0)
            return false;
        int min = (int)V4l2Device.Read(query, V4l2Layout.ControlMinAt);
        int max = (int)V4l2Device.Read(query, V4l2Layout.ControlMaxAt);
        byte[] argument = new byte[V4l2Layout.ControlBytes];
        V4l2Device.Write(argument, 0, control);
        V4l2Device.Write(
            argument, V4l2Layout.ControlValueAt, unchecked((uint)Math.Max(min, Math.Min(Math.Max(min, max), value))));
        return V4l2Device.Control(_system, _descriptor, V4l2Layout.SetControl, argument) >= 0;
    }

    private bool TryGet(uint control, out int value)
    {
        byte[] argument = new byte[V4l2Layout.ControlBytes];
        V4l2Device.Write(argument, 0, control);
        bool isGot = V4l2Device.Control(_system, _descriptor, V4l2Layout.GetControl, argument) >= 0;
        value = unchecked((int)V4l2Device.Read(argument, V4l2Layout.ControlValueAt));
        return isGot;
    }
}
