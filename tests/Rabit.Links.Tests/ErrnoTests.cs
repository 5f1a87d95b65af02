using System;
using Xunit;

namespace Rabit.Links.Tests;

/// <summary>What a user reads of an error number.</summary>
public sealed class ErrnoTests
{
    [Theory]
    [InlineData(2, "there is no such device")]
    [InlineData(13, "permission denied; add the user to the group 'dialout'")]
    [InlineData(16, "the device is in use by another program")]
    [InlineData(22, "the device or its driver refuses the setting (EINVAL)")]
    [InlineData(24, "too many files are open")]
    [InlineData(38, "the kernel or its emulation lacks a call that this needs (ENOSYS)")]
    [InlineData(95, "the kernel or its emulation lacks a call that this needs (ENOSYS)")]
    [InlineData(117, "error 117 of the operating system (errno)")]
    public void Describe_ErrorNumber_NamesIt(int errno, string expected)
        => Assert.StartsWith(expected, Errno.Describe(errno), StringComparison.Ordinal);
}
