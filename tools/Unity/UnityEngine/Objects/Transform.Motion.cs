namespace UnityEngine;

/// <summary>Translation, rotation, and conversion of points and directions between local and world space.</summary>
public partial class Transform
{
    public void Translate(Vector3 translation) => Translate(translation, Space.Self);

    public void Translate(Vector3 translation, Space relativeTo) =>
        position += relativeTo == Space.World ? translation : TransformDirection(translation);

    public void Translate(Vector3 translation, Transform relativeTo) =>
        position += IsNull(relativeTo) ? translation : relativeTo.TransformDirection(translation);

    public void Translate(float x, float y, float z) => Translate(new Vector3(x, y, z), Space.Self);

    public void Translate(float x, float y, float z, Space relativeTo) => Translate(new Vector3(x, y, z), relativeTo);

    public void Translate(float x, float y, float z, Transform relativeTo) =>
        Translate(new Vector3(x, y, z), relativeTo);

    public void Rotate(Vector3 eulers) => Rotate(eulers, Space.Self);

    public void Rotate(Vector3 eulers, Space relativeTo)
    {
        Quaternion turn = Quaternion.Euler(eulers);
        if (relativeTo == Space.Self)
            localRotation *= turn;
        else
            rotation = turn * rotation;
    }

    public void Rotate(float xAngle, float yAngle, float zAngle) =>
        Rotate(new Vector3(xAngle, yAngle, zAngle), Space.Self);

    public void Rotate(float xAngle, float yAngle, float zAngle, Space relativeTo) =>
        Rotate(new Vector3(xAngle, yAngle, zAngle), relativeTo);

    public void Rotate(Vector3 axis, float angle) => Rotate(axis, angle, Space.Self);

    public void Rotate(Vector3 axis, float angle, Space relativeTo)
    {
        Vector3 worldAxis = relativeTo == Space.Self ? TransformDirection(axis) : axis;
        rotation = Quaternion.AngleAxis(angle, worldAxis) * rotation;
    }

    public void RotateAround(Vector3 point, Vector3 axis, float angle)
    {
        Quaternion turn = Quaternion.AngleAxis(angle, axis);
        position = point + turn * (position - point);
        rotation = turn * rotation;
    }

    public void LookAt(Transform target) => LookAt(target, Vector3.up);

    public void LookAt(Transform target, Vector3 worldUp)
    {
        if (!IsNull(target))
            LookAt(target.position, worldUp);
    }

    public void LookAt(Vector3 worldPosition) => LookAt(worldPosition, Vector3.up);

    public void LookAt(Vector3 worldPosition, Vector3 worldUp)
    {
        Vector3 toward = worldPosition - position;
        if (toward.sqrMagnitude > 0f)
            rotation = Quaternion.LookRotation(toward, worldUp);
    }

    public Vector3 TransformPoint(Vector3 position)
    {
        for (Transform node = Alive(); node is not null; node = node._parent)
            position = node._localPosition + node._localRotation * Vector3.Scale(node._localScale, position);
        return position;
    }

    public Vector3 TransformPoint(float x, float y, float z) => TransformPoint(new Vector3(x, y, z));

    public Vector3 InverseTransformPoint(Vector3 position)
    {
        Vector3 inParent = Alive()._parent is null ? position : _parent.InverseTransformPoint(position);
        return Unscaled(Quaternion.Inverse(_localRotation) * (inParent - _localPosition));
    }

    public Vector3 InverseTransformPoint(float x, float y, float z) => InverseTransformPoint(new Vector3(x, y, z));

    public Vector3 TransformVector(Vector3 vector)
    {
        for (Transform node = Alive(); node is not null; node = node._parent)
            vector = node._localRotation * Vector3.Scale(node._localScale, vector);
        return vector;
    }

    public Vector3 TransformVector(float x, float y, float z) => TransformVector(new Vector3(x, y, z));

    public Vector3 InverseTransformVector(Vector3 vector)
    {
        Vector3 inParent = Alive()._parent is null ? vector : _parent.InverseTransformVector(vector);
        return Unscaled(Quaternion.Inverse(_localRotation) * inParent);
    }

    public Vector3 InverseTransformVector(float x, float y, float z) => InverseTransformVector(new Vector3(x, y, z));

    public Vector3 TransformDirection(Vector3 direction) => rotation * direction;

    public Vector3 TransformDirection(float x, float y, float z) => TransformDirection(new Vector3(x, y, z));

    public Vector3 InverseTransformDirection(Vector3 direction) => Quaternion.Inverse(rotation) * direction;

    public Vector3 InverseTransformDirection(float x, float y, float z) =>
        InverseTransformDirection(new Vector3(x, y, z));

    // A scale of zero has no inverse; Unity returns 0 along that axis.
    Vector3 Unscaled(Vector3 point) => new(
        _localScale.x == 0f ? 0f : point.x / _localScale.x,
        _localScale.y == 0f ? 0f : point.y / _localScale.y,
        _localScale.z == 0f ? 0f : point.z / _localScale.z);
}
