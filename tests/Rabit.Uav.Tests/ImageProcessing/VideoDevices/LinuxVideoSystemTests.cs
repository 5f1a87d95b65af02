using System;
using Rabit.Tests.Shared;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.ImageProcessing.VideoDevices;
using Xunit;

namespace Rabit.Uav.Tests.ImageProcessing.VideoDevices;

/// <summary>The calls of the device layer on the Linux that is here.</summary>
public sealed class LinuxVideoSystemTests
{
    [LinuxFact]
    public void Calls_OnThisMachine_AnswerAsTheyShould()
    {
        var system = new LinuxVideoSystem();
        VideoDeviceException none = Assert.Throws<VideoDeviceException>(
            () => new V4l2Device(system, new V4l2CameraOptions { Device = "/dev/no-such-camera" }));
        VideoDeviceException other = Assert.Throws<VideoDeviceException>(
            () => new V4l2Device(system, new V4l2CameraOptions { Device = "/dev/null" }));
        int zero = system.Open("/dev/zero");
        IntPtr memory = system.Map(zero, 0, 4096);

        Assert.Equal("there is no such device", none.Message);
        Assert.Equal("this is no video device", other.Message);
        Assert.True(zero >= 0 && memory != IntPtr.Zero);
        Assert.Equal(1, system.Wait(zero, 1000));
        system.Unmap(memory, 4096);
        system.Close(zero);
        Assert.True(system.Wait(-1, 0) == 0, "a descriptor below 0 is left out");
        long first = system.MonotonicMicroseconds();
        Assert.InRange(system.MonotonicMicroseconds() - first, 0, 10_000_000);
    }
}
