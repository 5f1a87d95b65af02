using System;
using System.Net;
using System.Net.Sockets;
using System.Text;

namespace Rabit.Hosting;

/// <summary>
/// The address of a Unix socket, in the file system or abstract (unix(7)): netstandard2.0 has none. Immutable.
/// </summary>
internal sealed class UnixDatagramEndPoint : EndPoint
{
    // sun_path, with the zero behind a path.
    private const int MaxBytes = 107;
    private const int FamilyBytes = 2;

    private readonly byte[] _name;

    /// <param name="address">An absolute path, or an abstract name behind an @.</param>
    /// <exception cref="FormatException">It is neither, or too long.</exception>
    public UnixDatagramEndPoint(string address)
    {
        char first = address.Length == 0 ? ' ' : address[0];
        if (first is not ('/' or '@'))
            throw new FormatException($"'{address}' is neither an absolute path nor an abstract name (@...).");

        // A path ends with a zero, an abstract name begins with one.
        byte[] name = Encoding.UTF8.GetBytes(address + "\0");
        if (name.Length > MaxBytes + 1)
            throw new FormatException($"'{address}' is longer than {MaxBytes} bytes.");
        if (first == '@')
        {
            name[0] = 0;
            Array.Resize(ref name, name.Length - 1);
        }

        _name = name;
    }

    public override AddressFamily AddressFamily => AddressFamily.Unix;

    public override SocketAddress Serialize()
    {
        var address = new SocketAddress(AddressFamily.Unix, FamilyBytes + _name.Length);
        for (int i = 0; i < _name.Length; i++)
            address[FamilyBytes + i] = _name[i];
        return address;
    }

    public override EndPoint Create(SocketAddress socketAddress) => this;
}
